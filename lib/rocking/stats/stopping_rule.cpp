#include "rocking/stats/stopping_rule.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

constexpr std::uint64_t first_look = 50;

/// The tightest where the run is expected to end, as far as that is known before it: with one category at p = 1/2.
double concentration_of(const StoppingGoal& goal) {
  const double doubt = goal.family.share();
  const double expected = std::min(trials_for(goal.half_width, doubt), static_cast<double>(goal.at_most));
  return concentration_for(expected, doubt);
}

}  // namespace

StoppingRule::StoppingRule(const StoppingGoal& goal) : goal_(goal), sequence_(concentration_of(goal)) {
  ROCKING_EXPECT(0.0 < goal.half_width && goal.half_width < 0.5);
  ROCKING_EXPECT(goal.at_most >= 1);
  ROCKING_EXPECT(0.0 < goal.family.confidence && goal.family.confidence < 1.0);
}

std::uint64_t StoppingRule::next_look(std::uint64_t trials) const {
  if (trials < first_look) return std::min(first_look, goal_.at_most);
  const std::uint64_t tens = trials / 10;
  return std::min(10 * (tens + std::max<std::uint64_t>(1, tens / 10)), goal_.at_most);
}

bool StoppingRule::narrow_enough(const CategoryCounts& counts) const {
  ROCKING_EXPECT(counts.foreseen.size() == goal_.family.foreseen);
  const auto narrow = [this](const Interval& interval) {
    return 0.5 * (interval.high - interval.low) <= goal_.half_width;
  };
  const auto foreseen = [&](std::uint64_t k) { return narrow(interval_of_foreseen({k, counts.trials})); };
  const auto unforeseen = [&](std::uint64_t k) { return narrow(interval_of_unforeseen({k, counts.trials})); };
  return std::all_of(counts.foreseen.begin(), counts.foreseen.end(), foreseen) &&
         std::all_of(counts.unforeseen.begin(), counts.unforeseen.end(), unforeseen) && unforeseen(0);
}

Interval StoppingRule::interval_of_foreseen(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_foreseen());
}

Interval StoppingRule::interval_of_unforeseen(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_unforeseen());
}

}  // namespace rocking::stats
