#include "rocking/plan/plan.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

#include "rocking/ensemble/pair_workers.hpp"
#include "rocking/lanes/kernels.hpp"

namespace rocking {
namespace {

/// A flag that is set at a time of the caller's clock, or when the caller asks to stop.
class Deadline {
 public:
  Deadline(const Sampling& sampling, double end)
      : watch_([this, end, &sampling](const std::stop_token& token) {
          constexpr std::chrono::milliseconds between_looks(5);
          while (!token.stop_requested() && sampling.elapsed_seconds() < end && !sampling.stop.is_made()) {
            std::this_thread::sleep_for(between_looks);
          }
          is_past_ = true;
        }) {}

  [[nodiscard]] const std::atomic<bool>* flag() const { return &is_past_; }

 private:
  std::atomic<bool> is_past_ = false;
  std::jthread watch_;
};

double periods_of(const Condition& condition) { return static_cast<double>(condition.horizon.periods()); }

/// Up to 1024 conditions, spread evenly over the sweep, also in every initial part of the list: in the order of their
/// reversed bits.
Experiment spread_conditions(const Experiment& experiment) {
  constexpr std::size_t most = 1024;
  Experiment sample{.title = "", .seed = experiment.seed, .conditions = {}, .canonical_text = ""};
  const std::size_t all = experiment.conditions.size();
  const auto bits = static_cast<unsigned>(std::bit_width(all - 1));
  for (std::size_t i = 0; i < std::bit_ceil(all) && sample.conditions.size() < most; ++i) {
    std::size_t reversed = 0;
    for (unsigned bit = 0; bit < bits; ++bit) reversed |= ((i >> bit) & 1U) << (bits - 1 - bit);
    if (reversed < all) sample.conditions.push_back(experiment.conditions[reversed]);
  }
  return sample;
}

/// Pairs of the conditions in turn. Each condition begins at another of its pairs, because reruns and label checks
/// belong to every N-th realisation.
class PairsInTurn {
 public:
  explicit PairsInTurn(const Experiment& sample) : sample_(&sample) {}

  /// Absent when every pair was given.
  [[nodiscard]] std::optional<Pair> next() {
    for (std::size_t tried = 0; tried < sample_->conditions.size(); ++tried) {
      const std::size_t condition = condition_;
      const std::uint64_t round = round_;
      if (++condition_ == sample_->conditions.size()) condition_ = 0, ++round_;
      const std::uint64_t pairs = (effective_realisations(sample_->conditions[condition]) + 1) / 2;
      if (round < pairs) return Pair{.condition = condition, .first = 2 * ((round + condition) % pairs)};
    }
    return std::nullopt;
  }
  [[nodiscard]] std::uint64_t size() const {
    std::uint64_t pairs = 0;
    for (const Condition& condition : sample_->conditions) pairs += (effective_realisations(condition) + 1) / 2;
    return pairs;
  }

 private:
  const Experiment* sample_;
  std::size_t condition_ = 0;
  std::uint64_t round_ = 0;
};

struct Measured {
  double periods = 0.0;  ///< that were run; half of those of the realisations in progress at the end
  double seconds = 0.0;
  std::uint64_t realisations = 0;
  std::uint64_t unresolved = 0;
};

Measured measure(const Experiment& sample, unsigned threads, double seconds, const Sampling& sampling) {
  PairsInTurn pairs(sample);
  std::uint64_t left = pairs.size();
  const auto realisations_in = [&sample](const Pair& pair) {
    return std::min<std::uint64_t>(2, effective_realisations(sample.conditions[pair.condition]) - pair.first);
  };
  const auto periods_in = [&](const Pair& pair) {
    return static_cast<double>(realisations_in(pair)) * periods_of(sample.conditions[pair.condition]);
  };
  Measured measured;
  double in_progress = 0.0;
  const double start = sampling.elapsed_seconds();
  const Deadline deadline(sampling, start + seconds);
  RunOptions options;
  options.threads = threads;
  options.stop_requested = deadline.flag();
  run_pairs(sample, options,
            {.next =
                 [&] {
                   const auto pair = pairs.next();
                   if (pair) in_progress += periods_in(*pair);
                   return pair;
                 },
             .accept =
                 [&](const Pair& pair, const std::vector<Summary>& summaries) {
                   in_progress -= periods_in(pair);
                   measured.periods += periods_in(pair);
                   measured.realisations += summaries.size();
                   for (const Summary& summary : summaries) {
                     if (summary.mode.kind == section::ResponseKind::unresolved) ++measured.unresolved;
                   }
                   --left;
                 },
             .left = [&] { return left; }});
  measured.seconds = sampling.elapsed_seconds() - start;
  if (measured.realisations > 0) measured.periods += 0.5 * in_progress;
  return measured;
}

/// Share of the horizons with which a sample of this time holds all realisations, or several times those in progress at
/// once, so that those in progress at its end count little.
double affordable_share(const Experiment& sample, const Measured& before, const Means& means, double seconds) {
  constexpr double rounds = 5.0;
  double longest = 0.0;
  double all = 0.0;
  for (const Condition& condition : sample.conditions) {
    longest = std::max(longest, periods_of(condition));
    all += static_cast<double>(effective_realisations(condition));
  }
  const double side_by_side = means.threads * 2.0 * static_cast<double>(lanes::available_kernels().back().lanes);
  return before.periods / before.seconds * seconds / (std::min(rounds * side_by_side, all) * longest);
}

}  // namespace

Horizon shortened(const Horizon& horizon, double share) {
  const auto part = [share](int periods) { return static_cast<int>(std::lround(share * periods)); };
  return {.transient_periods = part(horizon.transient_periods),
          .sampled_periods = std::max(1, part(horizon.sampled_periods))};
}

std::optional<TimeEstimate> estimate_time(const Experiment& experiment, const Means& means, const Sampling& sampling) {
  constexpr double first_s = 0.2;
  constexpr double fewest_periods = 16.0;
  const double start = sampling.elapsed_seconds();
  const Experiment full = spread_conditions(experiment);
  double longest = 0.0;
  double all_periods = 0.0;
  for (const Condition& condition : experiment.conditions) {
    longest = std::max(longest, periods_of(condition));
    all_periods += static_cast<double>(effective_realisations(condition)) * periods_of(condition);
  }
  double share = std::min(1.0, fewest_periods / longest);
  const auto measure_with = [&](double horizon_share, double seconds) {
    Experiment sample = full;
    for (Condition& condition : sample.conditions) condition.horizon = shortened(condition.horizon, horizon_share);
    return measure(sample, means.threads, seconds, sampling);
  };
  const auto time_left = [&] { return 0.95 * longest_sample_s - (sampling.elapsed_seconds() - start); };
  Measured measured = measure_with(share, first_s);
  if (measured.realisations > 0) share = std::clamp(affordable_share(full, measured, means, time_left()), share, 1.0);
  const Measured second = measure_with(share, time_left());
  if (sampling.stop.is_made() || second.realisations == 0) return std::nullopt;
  const double parts = means.shard ? static_cast<double>(means.shard->parts) : 1.0;
  // Shortened horizons are whole numbers, so the share that was run differs from the wanted one.
  return TimeEstimate{.seconds = second.seconds * all_periods / second.periods / parts,
                      .realisations = second.realisations,
                      .horizon_share = share,
                      .unresolved = share < 1.0 ? std::nullopt : std::optional(second.unresolved)};
}

}  // namespace rocking
