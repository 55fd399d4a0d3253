#include "rocking/dynamics/excitation/recorded.hpp"

#include <algorithm>
#include <cmath>

namespace rocking::dynamics {
namespace {

Instant instant_of(double tau, const Clock& clock) {
  const double since_zero = tau + clock.start();
  const double periods = std::floor(since_zero / clock.period_length());
  return {.period = static_cast<std::int64_t>(periods), .time = std::fma(-periods, clock.period_length(), since_zero)};
}

Knot at_rest(const Instant& instant) { return {.instant = instant, .horizontal = 0.0, .vertical = 0.0}; }

}  // namespace

NormalisedGroundMotion::NormalisedGroundMotion(const std::vector<GroundMotionSample>& samples,
                                               double frequency_parameter, const Clock& clock) {
  constexpr Instant never{.period = 0, .time = std::numeric_limits<double>::infinity()};
  knots_.reserve(samples.size() + 4);
  knots_.push_back(at_rest({.period = -2, .time = 0.0}));
  knots_.push_back(at_rest(samples.empty() ? never : instant_of(samples.front().time * frequency_parameter, clock)));
  for (const GroundMotionSample& sample : samples) {
    knots_.push_back({.instant = instant_of(sample.time * frequency_parameter, clock),
                      .horizontal = sample.horizontal,
                      .vertical = sample.vertical});
  }
  knots_.push_back(at_rest(knots_.back().instant));
  knots_.push_back(at_rest(never));
}

const Knot* NormalisedGroundMotion::last_reached(const Clock& clock, const Knot* guess) const {
  const auto is_reached = [&clock](const Knot& knot) { return clock.until(knot.instant) <= clock.resolution(); };
  if (guess != nullptr && is_reached(guess[0])) {
    if (!is_reached(guess[1])) return guess;
    if (!is_reached(guess[2])) return guess + 1;  // the last knot is never reached, so that this one is not the last
  }
  return &*std::partition_point(knots_.begin() + 1, knots_.end() - 1, is_reached) - 1;
}

const Knot* NormalisedGroundMotion::last_below(const Knot* reached, double bound, const Instant& limit,
                                               std::size_t most, const Clock& clock) {
  const double apart = 4.0 * clock.resolution();
  const auto is_step_away = [&](const Knot& from, const Knot& to) {
    const double gap = clock.between(from.instant, to.instant);
    return gap > apart && gap < 0.5 * clock.period_length();
  };
  const auto is_passed = [&](const Knot* knot) {  // the last knot of all is infinitely far away
    return is_step_away(knot[-1], knot[0]) && is_step_away(knot[0], knot[1]) && std::abs(knot->horizontal) < bound &&
           clock.between(knot->instant, limit) > apart;
  };
  if (!(std::abs(reached->horizontal) < bound)) return reached;
  const Knot* last = reached;
  for (; most > 0 && is_passed(last + 1); --most) ++last;
  return last;
}

}  // namespace rocking::dynamics
