// Overturning of a block by one cycle of a sine (cycloidal pulse of type A), alpha 0.25, eta 0.9, W = omega/p = 5: the case
// of Zhang & Makris (2001), J. Eng. Mech. 127(5) 473-483, who give 3.01, 6.33 and 7.18 for the edges of its bands.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/studies/threshold/question.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr double pulse_frequency = 5.0;
constexpr double kept_rate = 0.9;

ThresholdBands bands_for(double slenderness) {
  const Json experiment{
      {"format", "rocking.experiment/1"},
      {"block", {{"width_m", std::tan(slenderness)}, {"height_m", 1.0}}},
      {"excitation", {{"kind", "pulse"}, {"shape", "sine"}, {"amplitude", 1.0}, {"frequency_ratio", pulse_frequency}}},
      {"restitution", {{"rate_ratio", kept_rate}}}};
  const ThresholdQuestion question{.of = "/excitation/amplitude", .from = 1.0, .to = 10.0};
  return thresholds(experiment_in(experiment.dump()), question).conditions.at(0).found;
}

/// Where `holds` changes between two numbers.
double changes_at(const std::function<bool(double)>& holds, double low, double high) {
  const bool at_low = holds(low);
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) == at_low ? low : high) = middle;
  }
  return high;
}

// A slender block on side s: Theta'' = Theta - s + a sin(W tau). Its solution from (tau, tilt, rate) on is
//     Theta = s - b sin(W tau) + c cosh(t) + d sinh(t),   b = a/(1 + W^2),   t the time since then.
struct SlenderState {
  double tau, tilt, rate, side;
};

SlenderState slender_after(const SlenderState& start, double tau, double a) {
  const double b = a / (1.0 + pulse_frequency * pulse_frequency);
  const double c = start.tilt - start.side + b * std::sin(pulse_frequency * start.tau);
  const double d = start.rate + b * pulse_frequency * std::cos(pulse_frequency * start.tau);
  const double t = tau - start.tau;
  return {.tau = tau,
          .tilt = start.side - b * std::sin(pulse_frequency * tau) + c * std::cosh(t) + d * std::sinh(t),
          .rate = -b * pulse_frequency * std::cos(pulse_frequency * tau) + c * std::sinh(t) + d * std::cosh(t),
          .side = start.side};
}

/// Whether it overturns. It lifts at a sin(W tau) = 1. After the pulse (side Theta - 1)'' = side Theta - 1: it overturns
/// where the sum of that and its rate is positive; else it lands with a rate of sqrt(rate^2 - (1 - side Theta)^2 + 1), and
/// overturns over the other edge if eta times that exceeds 1.
bool overturns_slender(double a) {
  const double end = 2.0 * pi / pulse_frequency;
  SlenderState now{.tau = std::asin(1.0 / a) / pulse_frequency, .tilt = 0.0, .rate = 0.0, .side = 1.0};
  constexpr int samples = 4000;
  const double step = (end - now.tau) / samples;
  for (int i = 1; i <= samples; ++i) {
    const double next = i == samples ? end : end - (samples - i) * step;
    if (now.side * slender_after(now, next, a).tilt >= 0.0) continue;
    const auto has_landed = [&](double tau) { return now.side * slender_after(now, tau, a).tilt < 0.0; };
    now = slender_after(now, changes_at(has_landed, std::max(now.tau, next - step), next), a);
    now = {.tau = now.tau, .tilt = 0.0, .rate = kept_rate * now.rate, .side = -now.side};
  }
  now = slender_after(now, end, a);
  const double beyond = now.side * now.tilt - 1.0;
  if (beyond + now.side * now.rate > 0.0) return true;
  const double landing = std::sqrt(std::max(0.0, now.rate * now.rate - beyond * beyond + 1.0));
  return kept_rate * landing > 1.0;
}

/// Zhang & Makris (2001), Eq. 47: overturning without an impact.
bool overturns_at_once(double a) {
  const double root = std::sqrt(a * a - 1.0) - pulse_frequency;
  return root * std::exp((2.0 * pi - std::asin(1.0 / a)) / pulse_frequency) > a;
}

TEST(ThresholdOfAPulse, IsThatOfTheSlenderBlockInClosedForm) {
  constexpr double slenderness = 0.001;
  const ThresholdBands found = bands_for(slenderness);
  ASSERT_EQ(found.edges.size(), 3U);
  const std::array near{3.01860, 6.31808, 7.16813};  // to the digits that are written
  for (std::size_t i = 0; i < 3; ++i) {
    const double right = changes_at(overturns_slender, near[i] - 0.05, near[i] + 0.05);
    EXPECT_NEAR(found.edges[i].happens.value, right, 10.0 * slenderness * slenderness) << "terms of alpha^2";
    EXPECT_NEAR(found.edges[i].happens.value, near[i], 0.5e-5);
  }
  EXPECT_NEAR(changes_at(overturns_at_once, 7.0, 7.4), changes_at(overturns_slender, 7.1, 7.2), 1e-12);
}

TEST(ThresholdOfAPulse, FallsAfterOneImpactInTheFirstBandAndWithoutOneInTheSecond) {
  const ThresholdBands found = bands_for(0.25);
  ASSERT_EQ(found.edges.size(), 3U);
  EXPECT_EQ(found.edges[0].happens.impacts, 1U);
  EXPECT_EQ(found.edges[1].happens.impacts, 1U);
  EXPECT_EQ(found.edges[2].happens.impacts, 0U);
  // The true block, by an integrator that shares nothing with this program.
  EXPECT_NEAR(found.edges[0].happens.value, 3.0323, 0.5e-4);
  EXPECT_NEAR(found.edges[1].happens.value, 6.7430, 0.5e-4);
  EXPECT_NEAR(found.edges[2].happens.value, 7.4930, 0.5e-4);
}

}  // namespace
}  // namespace rocking
