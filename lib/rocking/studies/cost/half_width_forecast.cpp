#include "rocking/studies/cost/half_width_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "rocking/base/error.hpp"
#include "rocking/studies/cost/measurement.hpp"

namespace rocking {
namespace {

/// A share of realisations, and the significance of its interval.
struct Share {
  double value = 0.0;
  stats::Significance significance;
};

double half(const stats::Interval& interval) { return 0.5 * (interval.high - interval.low); }

stats::Proportion proportion(double share, std::uint64_t realisations) {
  const double count = std::round(share * static_cast<double>(realisations));
  return {.successes = static_cast<std::uint64_t>(count), .trials = realisations};
}

double half_width_of(const Share& share, std::uint64_t realisations) {
  return half(stats::exact_interval(proportion(share.value, realisations), share.significance));
}

std::vector<Share> shares_of(const ModeTally& modes, std::uint64_t trials, double confidence) {
  std::vector<Share> shares;
  for (const auto& [mode, count] : modes) {
    shares.push_back({.value = static_cast<double>(count) / static_cast<double>(trials),
                      .significance = significance_of(mode, confidence)});
  }
  return shares;
}

/// The share whose interval is the widest.
Share widest_of(const std::vector<Share>& shares, std::uint64_t realisations) {
  return *std::ranges::max_element(shares, {}, [&](const Share& share) { return half_width_of(share, realisations); });
}

/// That of `until`; a relative one is multiplied by the share of its mode. Absent if that mode did not occur.
std::optional<double> intended_half_width(const Until& until, const ModeTally& modes, std::uint64_t trials) {
  if (until.half_width) return until.half_width;
  const auto found = modes.find(*until.mode);
  if (found == modes.end()) return std::nullopt;
  return *until.relative_half_width * static_cast<double>(found->second) / static_cast<double>(trials);
}

/// Smallest number of realisations with this half-width. Counts are whole numbers, so it may be off by one or two.
std::uint64_t needed_for(const Share& share, double half_width, std::uint64_t most) {
  std::uint64_t too_few = 0;
  std::uint64_t enough = 1;
  while (enough < most && half_width_of(share, enough) > half_width) {
    too_few = enough;
    enough = std::min(most, 2 * enough);
  }
  while (enough - too_few > 1) {
    const std::uint64_t middle = too_few + (enough - too_few) / 2;
    (half_width_of(share, middle) > half_width ? too_few : enough) = middle;
  }
  return enough;
}

}  // namespace

HalfWidthForecast::HalfWidthForecast(const Experiment& experiment, std::span<const MeasuredRealisation> measured) {
  std::map<std::uint64_t, SampledCondition> sampled;
  for (const MeasuredRealisation& realisation : measured) {
    const Condition& condition = experiment.conditions[realisation.key.condition];
    if (!is_random(condition.scene)) continue;
    SampledCondition& entry =
        sampled.try_emplace(realisation.key.condition, SampledCondition{&condition, {}, 0}).first->second;
    ++entry.modes[realisation.runs.back().mode];
    ++entry.trials;
  }
  for (auto& [index, entry] : sampled) tallies_.push_back(std::move(entry));
}

HalfWidths HalfWidthForecast::at(std::uint64_t factor) const {
  ROCKING_EXPECT(!is_empty());
  HalfWidths widths;
  for (const auto& [condition, modes, trials] : tallies_) {
    const std::uint64_t realisations = factor * condition->realisations;
    const Share widest = widest_of(shares_of(modes, trials, condition->confidence), realisations);
    const double width = half_width_of(widest, realisations);
    widths.mean += width / static_cast<double>(tallies_.size());
    widths.widest = std::max(widths.widest, width);
    for (const auto& [mode, count] : modes) {
      const double share = static_cast<double>(count) / static_cast<double>(trials);
      const stats::Interval wilson = stats::wilson(proportion(share, realisations), condition->confidence);
      widths.widest_wilson = std::max(widths.widest_wilson, half(wilson));
    }
  }
  return widths;
}

std::optional<double> HalfWidthForecast::aim() const {
  if (is_empty()) return std::nullopt;
  double sum = 0.0;
  for (const auto& [condition, modes, trials] : tallies_) {
    const std::uint64_t n = condition->realisations;
    const auto intended = condition->until ? intended_half_width(*condition->until, modes, trials) : std::nullopt;
    sum += intended ? *intended : half_width_of(widest_of(shares_of(modes, trials, condition->confidence), n), n);
  }
  return sum / static_cast<double>(tallies_.size());
}

RealisationsNeeded HalfWidthForecast::needed(double half_width) const {
  ROCKING_EXPECT(!is_empty());
  ROCKING_EXPECT(0.0 < half_width && half_width < 0.5);
  const std::uint64_t n = tallies_.front().condition->realisations;
  std::vector<Share> widest;
  double highest = 0.0;
  for (const auto& [condition, modes, trials] : tallies_) {
    widest.push_back(widest_of(shares_of(modes, trials, condition->confidence), n));
    highest = std::max(highest, condition->confidence);
  }
  const Share half_of_all{.value = 0.5, .significance = mode_family(highest).of_others()};
  return {.by_shares = needed_for(widest_of(widest, n), half_width, most_needed),
          .at_most = needed_for(half_of_all, half_width, most_needed)};
}

}  // namespace rocking
