#include "rocking/stats/stopping_rule.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

constexpr std::uint64_t first_look = 50;

/// The concentration that is narrowest at the expected end of the run. Before the data, the end expected for one
/// category at p = 1/2 is used.
double concentration_of(const StoppingGoal& goal) {
  const double significance = goal.family.share();
  const double expected = std::min(trials_for(goal.half_width, significance), static_cast<double>(goal.at_most));
  return concentration_for(expected, significance);
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
  ROCKING_EXPECT(counts.prespecified.size() == goal_.family.prespecified);
  const auto narrow = [this](const Interval& interval) {
    return 0.5 * (interval.high - interval.low) <= goal_.half_width;
  };
  const auto prespecified = [&](std::uint64_t k) { return narrow(interval_of_prespecified({k, counts.trials})); };
  const auto others = [&](std::uint64_t k) { return narrow(interval_of_others({k, counts.trials})); };
  return std::all_of(counts.prespecified.begin(), counts.prespecified.end(), prespecified) &&
         std::all_of(counts.others.begin(), counts.others.end(), others) && others(0);
}

Interval StoppingRule::interval_of_prespecified(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_prespecified());
}

Interval StoppingRule::interval_of_others(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_others());
}

}  // namespace rocking::stats
