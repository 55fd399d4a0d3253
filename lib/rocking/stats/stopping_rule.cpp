#include "rocking/stats/stopping_rule.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

constexpr std::uint64_t first_look = 50;

/// Half-width at p = 1/2 that needs as many trials as the goal does at the probability for which it is tuned: p = 1/2,
/// the worst case, or, for a relative half-width r, p = 1/101, where (1 - p)/(p r^2) is (10/r)^2. The sequence also
/// averages an eighth and a sixty-fourth of that number of trials, which suit p = 0.07 and p = 0.39.
double tuned_half_width(const StoppingGoal& goal) {
  return goal.scale == HalfWidthScale::relative ? 0.05 * goal.half_width : goal.half_width;
}

/// The concentration that is narrowest at the expected end of the run. It depends on the goal only, because the
/// intervals would not be valid if the data determined it.
double concentration_of(const StoppingGoal& goal) {
  const double significance = goal.family.share();
  const double expected = std::min(trials_for(tuned_half_width(goal), significance), static_cast<double>(goal.at_most));
  return concentration_for(expected, significance);
}

}  // namespace

StoppingRule::StoppingRule(const StoppingGoal& goal) : goal_(goal), sequence_(concentration_of(goal)) {
  ROCKING_EXPECT(0.0 < goal.half_width && goal.half_width < (goal.scale == HalfWidthScale::relative ? 1.0 : 0.5));
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
  const auto prespecified = [&](std::uint64_t k) {
    const Proportion of_category{k, counts.trials};
    return narrow_enough(of_category, interval_of_prespecified(of_category));
  };
  const auto others = [&](std::uint64_t k) {
    const Proportion of_category{k, counts.trials};
    return narrow_enough(of_category, interval_of_others(of_category));
  };
  return std::all_of(counts.prespecified.begin(), counts.prespecified.end(), prespecified) &&
         std::all_of(counts.others.begin(), counts.others.end(), others) && others(0);
}

bool StoppingRule::narrow_enough(const Proportion& counts, const Interval& interval) const {
  const double half_width = 0.5 * (interval.high - interval.low);
  if (goal_.scale == HalfWidthScale::absolute) return half_width <= goal_.half_width;
  const double estimate = static_cast<double>(counts.successes) / static_cast<double>(counts.trials);
  return counts.successes > 0 && half_width <= goal_.half_width * estimate;
}

Interval StoppingRule::interval_of_prespecified(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_prespecified());
}

Interval StoppingRule::interval_of_others(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_others());
}

}  // namespace rocking::stats
