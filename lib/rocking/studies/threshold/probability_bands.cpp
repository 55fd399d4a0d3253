#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/stats/stopping_rule.hpp"
#include "rocking/studies/threshold/bands.hpp"

namespace rocking {
namespace {

/// Most values of a case that are tried between those of the scan.
constexpr std::size_t most_between = 100;
/// With which everything that is said of a case is right.
constexpr double confidence = 0.95;
/// By which most values are told from the probability.
constexpr double expected_realisations = 1000.0;

enum class Side : std::uint8_t { below, unclear, above };

/// A value of the number, and how often the event happened there.
struct Level {
  double value = 0.0;
  Trials happens;
  stats::Proportion counts = {};
  Side side = Side::unclear;

  [[nodiscard]] bool is_clear() const { return side != Side::unclear; }
  [[nodiscard]] ThresholdPoint point() const {
    return {.value = value, .happens = side == Side::above, .counts = counts};
  }
};

using LevelAt = std::function<Level(double value)>;

/// Adds realisations to values until the share of the event is told from the probability.
class Sampler {
 public:
  Sampler(const ThresholdQuestion& question, const base::ManyParts& how)
      : probability_(question.probability.value()),
        most_(question.realisations),
        how_(&how),
        significance_((1.0 - confidence) / static_cast<double>(*question.steps + 1 + most_between)),
        sequence_(stats::concentration_for(expected_realisations, significance_)) {}

  [[nodiscard]] bool is_finished(const Level& level) const { return level.is_clear() || level.counts.trials >= most_; }

  /// Some more realisations of each value that is not finished. The same numbers are drawn at every value.
  void sample(const std::vector<Level*>& levels) const {
    struct Trial {
      Level* level;
      std::uint64_t realisation;
      bool happens = false;
    };
    std::vector<Trial> trials;
    for (Level* level : levels) {
      if (is_finished(*level)) continue;
      const std::uint64_t done = level->counts.trials;
      const std::uint64_t next = std::min(most_, done + std::max<std::uint64_t>(20, done / 4));
      for (std::uint64_t k = done; k < next; ++k) trials.push_back({level, k});
    }
    base::for_each_part(*how_, trials.size(),
                        [&](std::size_t i) { trials[i].happens = trials[i].level->happens(trials[i].realisation); });
    for (const auto& [level, realisation, happens] : trials) {
      ++level->counts.trials;
      level->counts.successes += happens ? 1 : 0;
    }
    for (Level* level : levels) level->side = side_of(level->counts);
  }

 private:
  /// By a confidence sequence, which may be looked at after every batch.
  [[nodiscard]] Side side_of(const stats::Proportion& counts) const {
    const double evidence = sequence_.log_martingale(counts, probability_);
    if (!(evidence >= -base::natural_logarithm(significance_))) return Side::unclear;
    const double expected = probability_ * static_cast<double>(counts.trials);
    return static_cast<double>(counts.successes) < expected ? Side::below : Side::above;
  }

  double probability_;
  std::uint64_t most_;
  const base::ManyParts* how_;
  double significance_;
  stats::ConfidenceSequence sequence_;
};

/// Two values on different sides of the probability, which therefore lies between them.
struct Bracket {
  Level low;
  Level high;

  [[nodiscard]] double at(double share) const { return low.value + share * (high.value - low.value); }
  [[nodiscard]] bool is_within(double accuracy) const {
    return high.value - low.value <= accuracy * std::max(std::abs(low.value), std::abs(high.value));
  }
  [[nodiscard]] ThresholdEdge edge() const {
    const bool rises = high.side == Side::above;
    return {.stands = (rises ? low : high).point(), .happens = (rises ? high : low).point()};
  }
};

/// Neighbours on different sides, among the values that are on one.
std::vector<Bracket> changes_in(const std::vector<Level>& levels) {
  std::vector<Bracket> brackets;
  const Level* before = nullptr;
  for (const Level& level : levels) {
    if (!level.is_clear()) continue;
    if (before != nullptr && before->side != level.side) brackets.push_back({*before, level});
    before = &level;
  }
  return brackets;
}

/// Two values in the bracket, at its golden section, are sampled side by side, since one alone might be so near the edge that
/// it is on no side for long. One that is on none yet keeps its place in the narrower bracket. `left`: values that may be
/// tried.
Bracket narrowed(Bracket bracket, double accuracy, const LevelAt& level_at, const Sampler& sampler, std::size_t& left) {
  constexpr double farther = 1.0 / std::numbers::phi;
  std::vector<Level> between;
  while (!bracket.is_within(accuracy)) {
    if (std::size_t missing = 2 - between.size(); missing <= left) {
      left -= missing;
    } else {
      break;
    }
    if (between.empty()) between.push_back(level_at(bracket.at(1.0 - farther)));
    if (between.size() == 1) {
      const bool is_first = between.front().value < bracket.at(0.5);
      between.insert(is_first ? between.end() : between.begin(),
                     level_at(bracket.at(is_first ? farther : 1.0 - farther)));
    }
    if (std::ranges::all_of(between, [&](const Level& level) { return sampler.is_finished(level); })) break;
    sampler.sample({&between[0], &between[1]});
    bracket = changes_in({bracket.low, between[0], between[1], bracket.high}).front();
    std::erase_if(between, [&](const Level& level) {
      return level.is_clear() || level.value < bracket.low.value || level.value > bracket.high.value;
    });
  }
  return bracket;
}

ThresholdBands bands_of_levels(const std::vector<Level>& scan, const std::vector<Bracket>& changes,
                               std::vector<ThresholdEdge> edges) {
  std::vector<ThresholdPoint> clear;
  std::vector<double> unclear;
  for (const Level& level : scan) {
    const bool is_within_change = std::ranges::any_of(changes, [value = level.value](const Bracket& change) {
      return change.low.value < value && value < change.high.value;
    });
    if (level.is_clear()) {
      clear.push_back(level.point());
    } else if (!is_within_change) {
      unclear.push_back(level.value);
    }
  }
  ThresholdBands found = clear.empty() ? ThresholdBands{} : with_bands(clear, std::move(edges));
  found.without_answer = std::move(unclear);
  return found;
}

}  // namespace

std::vector<ThresholdBands> bands_by_probability(std::size_t count, const ThresholdQuestion& question,
                                                 const TrialsAt& trials_at, const RunOptions& options) {
  const base::ManyParts how{.threads = options.threads, .stop = options.stop_requested};
  const std::vector<double> values = scanned_values(question);
  const Sampler sampler(question, how);
  std::vector<ThresholdBands> found;
  std::uint64_t done = 0;
  std::uint64_t all = count * values.size();
  const auto advance = [&] {
    if (options.on_progress) options.on_progress(++done, all);
  };
  for (std::size_t place = 0; place < count; ++place) {
    const LevelAt level_at = [&trials_at, place](double value) {
      return Level{.value = value, .happens = trials_at(place, value)};
    };
    std::vector<Level> scan;
    for (const double value : values) {
      Level& level = scan.emplace_back(level_at(value));
      while (!sampler.is_finished(level)) sampler.sample({&level});
      advance();
    }
    const std::vector<Bracket> changes = changes_in(scan);
    all += changes.size();
    std::vector<ThresholdEdge> edges;
    std::size_t left = most_between;
    for (const Bracket& change : changes) {
      edges.push_back(narrowed(change, *question.accuracy, level_at, sampler, left).edge());
      advance();
    }
    found.push_back(bands_of_levels(scan, changes, std::move(edges)));
  }
  return found;
}

}  // namespace rocking
