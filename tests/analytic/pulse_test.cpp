// Blocks under one pulse of the base: overturning of slender blocks in closed form, long pulses, and the shapes against
// finely sampled ground motions.

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;
using dynamics::PulseShape;

/// A block of height `height` times its width, which cannot slide, at rest.
Condition under_pulse(const Pulse& pulse, double height = 4.0) {
  Condition condition;
  condition.scene.block.height = height;
  condition.scene.excitation = pulse;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 40};
  return condition;
}

/// How a run under a pulse ended.
struct Ending {
  bool overturned;
  std::size_t impacts;
};

Ending ending_of(const Condition& condition) {
  const Trajectory trajectory = run(condition, condition.horizon.sampled_periods);
  const auto impacts = std::ranges::count(trajectory.events, EventKind::impact_stick, &TrajectoryEvent::kind);
  return {.overturned = trajectory.termination == Termination::overturned,
          .impacts = static_cast<std::size_t>(impacts)};
}

/// Where `holds` changes from false to true between two numbers, to 40 halvings.
double first_true(const std::function<bool(double)>& holds, double low, double high) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

// --- a slender block under one cycle of a sine
// -------------------------------------------------------------------------
//
// psi -> 0: Theta'' = Theta - 1 + a sin(W tau), a = A_h, while it rocks about its first edge. It lifts at sin(u) = 1/a,
// u = W tau:
//
//     Theta = 1 - a sin(W tau)/(1 + W^2) + (-W^2 cosh(s) + W sqrt(a^2 - 1) sinh(s))/(1 + W^2),   s = tau - u/W
//
// After the pulse Theta'' = Theta - 1, and it overturns if Theta - 1 + Theta' > 0 then. At the end of the pulse, sine
// 0, cosine 1, without an impact until then, that is (W sqrt(a^2 - 1) - W^2) e^s > a W:
//
//     (sqrt(a^2 - 1) - W) exp((2 pi - arcsin(1/a))/W) > a

double least_without_impact(double ratio) {
  const auto overturns = [ratio](double a) {
    return (std::sqrt(a * a - 1.0) - ratio) * std::exp((2.0 * pi - std::asin(1.0 / a)) / ratio) > a;
  };
  return first_true(overturns, 1.0, 10.0 + ratio * ratio);
}

/// The state of the slender block, Theta > 0 on its first edge.
struct Slender {
  double tau;
  double tilt;
  double rate;
};

/// `start` carried on to `tau` under Theta'' = Theta - side + a sin(W tau).
Slender carried(const Slender& start, double tau, double side, double a, double ratio) {
  const double scale = a / (1.0 + ratio * ratio);
  const auto forced = [&](double t) { return side - scale * std::sin(ratio * t); };
  const auto forced_rate = [&](double t) { return -scale * ratio * std::cos(ratio * t); };
  const double c = start.tilt - forced(start.tau);
  const double d = start.rate - forced_rate(start.tau);
  const double s = tau - start.tau;
  return {tau, forced(tau) + c * std::cosh(s) + d * std::sinh(s),
          forced_rate(tau) + c * std::sinh(s) + d * std::cosh(s)};
}

/// Whether it overturns over the other edge after one impact during the pulse, which takes no energy (psi -> 0).
bool overturns_with_one_impact(double a, double ratio) {
  const double end = 2.0 * pi / ratio;
  const double lift = std::asin(1.0 / a) / ratio;
  const Slender lifted{lift, 0.0, 0.0};
  double down = end;
  for (int i = 1; i <= 4000 && down == end; ++i) {
    const double tau = lift + (end - lift) * i / 4000.0;
    if (carried(lifted, tau, 1.0, a, ratio).tilt < 0.0) down = tau;
  }
  if (down == end) return false;
  const double step = (end - lift) / 4000.0;
  const double impact =
      first_true([&](double tau) { return carried(lifted, tau, 1.0, a, ratio).tilt < 0.0; }, down - step, down);
  Slender there = carried(lifted, impact, 1.0, a, ratio);
  there.tilt = 0.0;
  const Slender last = carried(there, end, -1.0, a, ratio);
  return last.tilt < 0.0 && -last.tilt - 1.0 - last.rate > 0.0;
}

/// Boundaries for blocks of heights 50, 100 and 200 tend to `limit` with the square of psi.
void expect_second_order_in_psi(const std::function<double(double)>& boundary, double limit) {
  double last_error = 0.0;
  for (const double height : {50.0, 100.0, 200.0}) {
    const double error = std::abs(boundary(height) / limit - 1.0);
    EXPECT_LT(error, 20.0 / (height * height)) << height;
    EXPECT_NEAR(last_error / error, 4.0, last_error == 0.0 ? 1e9 : 0.1) << height;
    last_error = error;
  }
}

TEST(SinePulse, OverturnsASlenderBlockWithoutImpactFromTheClosedFormOn) {
  for (const double ratio : {1.0, 3.0, 5.0}) {
    const double limit = least_without_impact(ratio);
    const auto boundary = [&](double height) {
      const auto overturns = [&](double a) {
        const Ending ending =
            ending_of(under_pulse({.shape = PulseShape::sine, .amplitude = a, .frequency_ratio = ratio}, height));
        return ending.overturned && ending.impacts == 0;
      };
      return first_true(overturns, 0.98 * limit, 1.02 * limit);
    };
    expect_second_order_in_psi(boundary, limit);
  }
}

TEST(SinePulse, OverturnsASlenderBlockWithOneImpactFromTheClosedFormOn) {
  for (const double ratio : {2.0, 3.0}) {
    const double limit = first_true([&](double a) { return overturns_with_one_impact(a, ratio); }, 1.001,
                                    0.7 * least_without_impact(ratio));
    const auto boundary = [&](double height) {
      const auto overturns = [&](double a) {
        const Ending ending =
            ending_of(under_pulse({.shape = PulseShape::sine, .amplitude = a, .frequency_ratio = ratio}, height));
        return ending.overturned && ending.impacts == 1;
      };
      return first_true(overturns, 0.98 * limit, 1.02 * limit);
    };
    expect_second_order_in_psi(boundary, limit);
  }
}

// Zhang & Makris (2001), J. Eng. Mech. 127(5) 473-483: between the accelerations that overturn with one impact and
// those that overturn without impact the block stands.
TEST(SinePulse, LeavesASafeBandBetweenTheTwoWaysOfOverturning) {
  const auto under = [](double amplitude) {
    return ending_of(under_pulse({.shape = PulseShape::sine, .amplitude = amplitude, .frequency_ratio = 5.0}));
  };
  std::vector<std::pair<bool, std::size_t>> ways;
  for (double amplitude = 1.1; amplitude < 9.0; amplitude += 0.1) {
    const auto [overturned, impacts] = under(amplitude);
    const std::pair way{overturned, overturned ? impacts : 0U};
    if (ways.empty() || ways.back() != way) ways.push_back(way);
  }
  const std::vector<std::pair<bool, std::size_t>> expected{{false, 0U}, {true, 1U}, {false, 0U}, {true, 0U}};
  EXPECT_EQ(ways, expected);
}

// The corners are in units of psi, and blocks of one p share what is drawn for one of them.
TEST(RectanglePulse, HasTheSizeOfEachBlock) {
  SharedExcitation shared;
  for (const double psi : {0.1, 0.2, 0.1}) {
    Condition condition = under_pulse({.shape = PulseShape::rectangle, .amplitude = 2.0});
    condition.scene.block.mass = GivenSlenderness{.frequency_parameter = 2.0, .slenderness = psi};
    const random::BranchedDraws draws(random::Draws(0, 0));
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 1);
    EXPECT_NEAR(shared.of(condition.scene, beginning).horizontal(beginning.clock, 1.0), psi, 1e-16);
  }
}

// --- a slender block under a pulse of one sign
// -----------------------------------------------------------------------------
//
// After a pulse that it survives without impact the slender block overturns if Theta - 1 + Theta' > 0.

/// Least A_h at which it does, of a block `height` times as high as wide.
double least_of_one_sign(PulseShape shape, double ratio, double height, double low, double high) {
  const auto overturns = [&](double a) {
    return ending_of(under_pulse({.shape = shape, .amplitude = a, .frequency_ratio = ratio}, height)).overturned;
  };
  return first_true(overturns, low, high);
}

// Housner (1963) Eq. 9, a rectangle of duration t: Theta - 1 + Theta' = (a - 1) e^t - a at its end.
TEST(RectanglePulse, OverturnsASlenderBlockFromTheAccelerationOfHousnerOn) {
  for (const auto& [duration, published] : {std::pair{0.5, 2.541494}, {1.0, 1.581977}, {2.0, 1.156518}}) {
    const double limit = 1.0 / (1.0 - std::exp(-duration));
    EXPECT_NEAR(limit, published, 5e-7);
    expect_second_order_in_psi(
        [&, ratio = pi / duration](double height) {
          return least_of_one_sign(PulseShape::rectangle, ratio, height, 0.98 * limit, 1.02 * limit);
        },
        limit);
  }
}

// Makris & Roussos (2000) Eq. 27: Theta - 1 + Theta' = (a W + (W sqrt(a^2 - 1) - W^2) e^s)/(1 + W^2) at the end of half a
// sine, s = (pi - arcsin(1/a))/W after it lifts.
double least_under_half_sine(double ratio) {
  return first_true(
      [ratio](double a) { return (ratio - std::sqrt(a * a - 1.0)) * std::exp((pi - std::asin(1.0 / a)) / ratio) < a; },
      1.0, 1.0 + ratio * ratio);
}

TEST(HalfSinePulse, OverturnsASlenderBlockFromTheAccelerationOfMakrisAndRoussosOn) {
  for (const auto& [ratio, published] : {std::pair{0.5, 1.1094}, {1.0, 1.3224}, {2.0, 1.8007}, {3.0, 2.2939}}) {
    const double limit = least_under_half_sine(ratio);
    EXPECT_NEAR(limit, published, 5e-5);
    expect_second_order_in_psi(
        [&, w = ratio](double height) {
          return least_of_one_sign(PulseShape::half_sine, w, height, 0.98 * limit, 1.02 * limit);
        },
        limit);
  }
  // Their block, b = 0.2 m and h = 0.6 m, under half a sine of 0.5 s: stands at 5.430, falls at 5.440 m/s^2.
  const dynamics::Geometry block = dynamics::geometry_of({.width = 0.4, .height = 1.2, .gravity = 9.80665});
  const double least = least_under_half_sine(2.0 * pi / block.frequency_parameter);
  EXPECT_NEAR(least * block.shape_angle * 9.80665, 5.4391, 5e-5);
}

// Theta'' = Theta - 1 + a sin(W tau) does not grow without an impact for a^2 <= 1 + W^2, and grows above that with W ->
// 0; the least amplitude of a block lifts it, alpha = tan(psi), with an excess of second order in W.
TEST(LongPulse, OverturnsFromTheStaticAccelerationOn) {
  for (const PulseShape shape : {PulseShape::sine, PulseShape::ricker}) {
    const double psi = dynamics::geometry_of({}).shape_angle;
    double last_excess = 0.0;
    for (const double ratio : {0.1, 0.05, 0.025}) {
      const auto overturns = [&](double alpha) {
        return ending_of(under_pulse({.shape = shape, .amplitude = alpha / psi, .frequency_ratio = ratio})).overturned;
      };
      const double excess = first_true(overturns, std::tan(psi), 1.2 * std::tan(psi)) / std::tan(psi) - 1.0;
      EXPECT_GT(excess, 0.0);
      EXPECT_LT(excess, 2.0 * ratio * ratio);
      EXPECT_NEAR(last_excess / excess, 4.0, last_excess == 0.0 ? 1e9 : 0.2) << ratio;
      last_excess = excess;
    }
  }
}

TEST(CosinePulse, LiftsABlockAtOnceIfItsPeakIsAboveTheThreshold) {
  const double threshold = std::tan(dynamics::geometry_of({}).shape_angle) / dynamics::geometry_of({}).shape_angle;
  const auto first_event = [](double amplitude) {
    return run(under_pulse({.shape = PulseShape::cosine, .amplitude = amplitude, .frequency_ratio = 8.0}), 5)
        .events.at(0);
  };
  EXPECT_EQ(first_event(1.0001 * threshold).kind, EventKind::lift);
  EXPECT_EQ(first_event(1.0001 * threshold).tau, 0.0);
  EXPECT_TRUE(
      run(under_pulse({.shape = PulseShape::cosine, .amplitude = 0.9999 * threshold, .frequency_ratio = 8.0}), 5)
          .events.empty());
}

// Many papers count abs(Theta) = 1 as overturned; a pulse that goes on may bring the block back from there.
TEST(TheBalance, EndsAMotionWhereThatIsAsked) {
  int came_back = 0;
  for (double amplitude = 1.2; amplitude < 9.0; amplitude += 0.1) {
    Condition condition = under_pulse({.shape = PulseShape::sine, .amplitude = amplitude, .frequency_ratio = 5.0});
    const Trajectory whole = run(condition, 40);
    condition.horizon.until = MotionEnd::balance;
    const Trajectory cut = run(condition, 40);
    const auto passed = std::ranges::find(whole.events, EventKind::past_balance, &TrajectoryEvent::kind);
    if (passed == whole.events.end()) {
      EXPECT_EQ(cut.termination, Termination::reached_horizon) << amplitude;
      continue;
    }
    ASSERT_EQ(cut.termination, Termination::overturned) << amplitude;
    EXPECT_EQ(cut.events.back().kind, EventKind::past_balance) << amplitude;
    EXPECT_EQ(cut.events.back().tau, passed->tau) << amplitude;
    if (whole.termination == Termination::reached_horizon) ++came_back;
  }
  EXPECT_GT(came_back, 0);
}

// --- a pulse as a sampled ground motion
// -------------------------------------------------------------------------------

constexpr double ratio_of_pulse = 3.0;
constexpr double amplitude_of_pulse = 1.9;

/// Base acceleration over A_h psi of a shape, x = Omega_h tau since its begin, by the C library.
double shape_at(const Pulse& pulse, double x) {
  const double y = x - pi * dynamics::pulse_length(pulse.form());  // from the middle
  const double gamma = pulse.cycles;
  switch (pulse.shape) {
    case PulseShape::sine:
    case PulseShape::half_sine: return std::sin(x + pulse.phase_of_shape);
    case PulseShape::cosine: return std::cos(x + pulse.phase_of_shape);
    case PulseShape::rectangle: return 1.0;
    case PulseShape::triangle: return 1.0 - std::abs(y) / (0.5 * pi);
    case PulseShape::type_c: return gamma == 2.0 ? -std::sin(y) : std::sin(y);
    case PulseShape::mavroeidis_papageorgiou:
      return -0.5 * (std::sin(y / gamma) / gamma * std::cos(y + pulse.phase_of_shape) +
                     (1.0 + std::cos(y / gamma)) * std::sin(y + pulse.phase_of_shape));
    case PulseShape::ricker: break;
  }
  return (1.0 - 0.5 * y * y) * std::exp(-0.25 * y * y);
}

/// The strobe points of a block that rocks without slip under the pulse or under its samples.
std::vector<TrajectorySample> strobe_under(const Excitation& excitation) {
  Condition condition;
  condition.scene.excitation = excitation;
  return run(condition, 4).strobe;
}

Recorded sampled(const Pulse& pulse, int samples) {
  const dynamics::Geometry block = dynamics::geometry_of({});
  const double length = 2.0 * pi * dynamics::pulse_length(pulse.form());
  GroundMotion motion;
  for (int i = 0; i <= samples; ++i) {
    const double x = length * i / samples;
    motion.samples.push_back({.time = x / ratio_of_pulse / block.frequency_parameter,
                              .horizontal = mean_of(pulse.amplitude) * block.shape_angle * shape_at(pulse, x),
                              .vertical = 0.0});
  }
  return support::recorded_by(std::move(motion), ratio_of_pulse);
}

double distance(const std::vector<TrajectorySample>& a, const std::vector<TrajectorySample>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max({largest, std::abs(a[i].tilt - b.at(i).tilt), std::abs(a[i].tilt_rate - b.at(i).tilt_rate),
                        std::abs(a[i].slip - b.at(i).slip), std::abs(a[i].slip_rate - b.at(i).slip_rate)});
  }
  return largest;
}

// A line between samples h apart differs from the shape by at most (h^2/8) max(f'').
TEST(PulseExcitation, IsTheLimitOfItsSamplesWithTheSquareOfTheirSpacing) {
  for (Pulse pulse :
       {Pulse{.shape = PulseShape::sine}, Pulse{.shape = PulseShape::cosine}, Pulse{.shape = PulseShape::ricker},
        Pulse{.shape = PulseShape::half_sine}, Pulse{.shape = PulseShape::cosine, .phase_of_shape = 0.6},
        Pulse{.shape = PulseShape::type_c, .cycles = 1.0}, Pulse{.shape = PulseShape::type_c, .cycles = 2.0},
        Pulse{.shape = PulseShape::mavroeidis_papageorgiou, .phase_of_shape = 0.9, .cycles = 1.7}}) {
    pulse.amplitude = amplitude_of_pulse;
    pulse.frequency_ratio = ratio_of_pulse;
    const auto exact = strobe_under(pulse);
    ASSERT_GT(exact.size(), 1U);
    const double coarse = distance(exact, strobe_under(sampled(pulse, 500)));
    const double fine = distance(exact, strobe_under(sampled(pulse, 1000)));
    EXPECT_GT(coarse, 1e-9);
    EXPECT_NEAR(coarse / fine, 4.0, 0.1) << static_cast<int>(pulse.shape);
  }
}

TEST(PulseExcitation, IsItsCornersWhereItIsLinear) {
  for (const auto& [shape, amplitude] :
       {std::pair{PulseShape::rectangle, 1.3}, std::pair{PulseShape::triangle, 1.9}}) {  // which it survives
    const Pulse pulse{.shape = shape, .amplitude = amplitude, .frequency_ratio = ratio_of_pulse};
    const auto exact = strobe_under(pulse);
    ASSERT_GT(exact.size(), 1U);
    EXPECT_GT(std::abs(exact.front().tilt), 0.01) << "the block rocks";
    EXPECT_LT(distance(exact, strobe_under(sampled(pulse, 2))), 1e-11) << static_cast<int>(shape);
  }
}

// --- random amplitude
// -------------------------------------------------------------------------------------------------

TEST(PulseExcitation, HasOneRandomAmplitudeInARealisation) {
  Condition condition = under_pulse({.shape = PulseShape::ricker, .amplitude = 2.0, .frequency_ratio = 3.0});
  condition.scene.fluctuation.amplitude = 0.3;
  const random::Draws draws(0x2012, 5);
  const double drawn = 2.0 + 0.3 * draws.standard_normal(random::Source::amplitude, 0);
  Condition same = under_pulse({.shape = PulseShape::ricker, .amplitude = drawn, .frequency_ratio = 3.0});
  const RealisationResult random = realise(condition, 0x2012, 5);
  const RealisationResult fixed = realise(same, 0x2012, 5);
  EXPECT_EQ(random.operations.amplitude_draws, 1U);
  EXPECT_EQ(random.operations.steps, fixed.operations.steps) << "no breakpoint at a period";
  ASSERT_EQ(random.strobe.size(), fixed.strobe.size());
  for (std::size_t i = 0; i < random.strobe.size(); ++i) EXPECT_EQ(random.strobe[i].tilt, fixed.strobe[i].tilt);
}

}  // namespace
}  // namespace rocking
