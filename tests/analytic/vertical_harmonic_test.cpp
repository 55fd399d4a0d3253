// Blocks on a base that moves vertically as a sine of its own: closed forms at rest and in sliding, an independent
// integrator in rocking, a sampled sine with friction and impacts.

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/dynamics/excitation/harmonic.hpp"
#include "rocking/realisation/poincare_map.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;

/// alpha_v = `amplitude` sin(`frequency` tau + `phase`), accelerations over g.
VerticalHarmonic sine_of(double amplitude, double frequency, double phase) {
  return {.frequency_ratio = frequency,
          .phase = phase,
          .physical_amplitude = PhysicalAmplitude{amplitude, AccelerationUnit::gravity}};
}

/// The reference block under A_h sin(10 tau + 0.4) and a vertical sine.
Condition shaken_both_ways(double amplitude, const VerticalHarmonic& vertical,
                           const std::optional<Friction>& friction = std::nullopt) {
  Condition condition = support::shaken(amplitude, friction);
  support::harmonic(condition.scene).phase = 0.4;
  support::harmonic(condition.scene).vertical = vertical;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 20};
  return condition;
}

// The argument of the vertical sine is that of the time since the start, however many periods have passed. The long
// double has 64 bits: 2^-63 of 2^20 turns is 1e-13 of a turn. A whole ratio repeats to the bit.
TEST(VerticalSine, IsThatOfTheTimeSinceTheStart) {
  for (const auto& [cycles, periods] : {std::pair{2.0, 1.0}, {1.0, 3.0}, {std::sqrt(2.0), 1.0}, {0.37, 1.0}}) {
    const double frequency = 10.0, phase = 0.4, vertical_phase = 1.3;
    dynamics::Clock clock(frequency, phase);
    const dynamics::HarmonicExcitation<true> base(
        {.amplitude = 0.6, .cycles = cycles, .periods = periods, .phase = vertical_phase}, clock);
    for (const std::int64_t period : {0, 1, 2, 3, 1000, 1'000'000}) {
      for (const double share : {0.0, 0.3, 0.9}) {
        clock.set({.period = period, .time = share * clock.period_length()});
        const long double turn = 2.0L * std::numbers::pi_v<long double>;
        const long double horizontal =
            turn * static_cast<long double>(period) + static_cast<long double>(frequency) * clock.now().time - 0.4L;
        const long double angle = static_cast<long double>(cycles) / static_cast<long double>(periods) * horizontal +
                                  static_cast<long double>(vertical_phase);
        EXPECT_NEAR(base.weight(clock), static_cast<double>(1.0L + 0.6L * std::sin(angle)), 2e-12)
            << cycles << "/" << periods << " " << period << " " << share;
      }
    }
    if (cycles != std::floor(cycles)) continue;
    const auto weight_at = [&](std::int64_t period) {
      clock.set({.period = period, .time = 0.1});
      return base.weight(clock);
    };
    const auto whole = static_cast<std::int64_t>(periods);
    EXPECT_EQ(weight_at(0), weight_at(2 * whole));
    EXPECT_EQ(weight_at(0), weight_at(1'000'000 * whole));
  }
}

// Full contact holds as long as the block has weight. Without horizontal motion it then lifts over the left edge.
TEST(VerticalHarmonic, MovesNoBlockAtRestBeforeItsWeightIsGone) {
  for (const bool slides : {false, true}) {
    const auto friction = slides ? std::optional(Friction{0.2, 0.2}) : std::nullopt;
    for (const double frequency : {23.0, 10.0, 3.7}) {
      for (const double phase : {0.0, 2.0, -0.5}) {
        Condition condition = shaken_both_ways(0.0, sine_of(0.999, frequency, phase), friction);
        EXPECT_TRUE(run(condition, 200).events.empty());
        support::harmonic(condition.scene).vertical = sine_of(1.25, frequency, phase);
        const Trajectory trajectory = run(condition, 20);
        ASSERT_FALSE(trajectory.events.empty());
        double angle = pi + std::asin(0.8) - phase;
        while (angle - 2.0 * pi > 0.0) angle -= 2.0 * pi;
        EXPECT_NEAR(trajectory.events[0].tau, angle / frequency, 1e-14) << frequency << " " << phase;
        EXPECT_EQ(trajectory.events[0].kind, slides ? EventKind::slide_start : EventKind::lift);
      }
    }
  }
}

// abs(alpha) = tan(psi) (1 + alpha_v), with equal frequencies: (A_h psi sin(x) - tan(psi) A_v sin(x + d)) = tan(psi).
TEST(VerticalHarmonic, ChangesTheAccelerationThatLifts) {
  const double psi = std::atan(0.25);
  for (const double amplitude : {1.7, 2.0}) {
    for (const double share : {-0.3, 0.2, 0.5}) {
      const Condition condition =
          shaken_both_ways(amplitude, sine_of(std::abs(share), 10.0, share < 0.0 ? 0.4 + pi : 0.4));
      const double peak = amplitude * psi - 0.25 * share;  // to the right; the other direction adds the share
      const Trajectory trajectory = run(condition, 2);
      ASSERT_FALSE(trajectory.events.empty());
      EXPECT_EQ(trajectory.events[0].kind, EventKind::lift);
      EXPECT_NEAR(trajectory.events[0].tau, (std::asin(0.25 / peak) - 0.4) / 10.0, 1e-14) << amplitude << " " << share;
    }
  }
}

// V = V0 - (4/3) mu_k (tau + (A_v/Omega_v) (cos(Phi_v) - cos(Omega_v tau + Phi_v))), and X its integral.
TEST(VerticalHarmonic, PressesASlidingBlockOnItsBase) {
  const double mu = 0.15, start = 3.0, amplitude = 0.7, phase = 1.1;
  for (const double frequency : {20.0, 10.0, 5.0, 13.7}) {
    Condition condition = shaken_both_ways(0.0, sine_of(amplitude, frequency, phase), Friction{mu, mu});
    condition.scene.initial.slip_rate = start;
    const Trajectory trajectory = run(condition, 20);
    for (const auto& sample : trajectory.strobe) {
      const double tau = 0.2 * pi * static_cast<double>(sample.period);
      const double angle = frequency * tau + phase;
      const double pressed = tau + amplitude / frequency * (std::cos(phase) - std::cos(angle));
      const double moved =
          0.5 * tau * tau +
          amplitude / frequency * (std::cos(phase) * tau - (std::sin(angle) - std::sin(phase)) / frequency);
      EXPECT_NEAR(sample.slip_rate, start - 4.0 / 3.0 * mu * pressed, 2e-13) << sample.period << " " << frequency;
      EXPECT_NEAR(sample.slip, start * tau - 4.0 / 3.0 * mu * moved, 2e-12) << sample.period << " " << frequency;
    }
  }
}

/// theta and w of a hop, by the extrapolated modified midpoint rule in 64 bits; shares nothing with the library.
/// Source: Hairer, Noersett & Wanner (1993), Solving ordinary differential equations I, section II.9 (GBS).
std::array<long double, 2> hop(std::array<long double, 2> at, long double tau, int pieces, auto&& acceleration) {
  constexpr int columns = 9;
  for (int piece = 0; piece < pieces; ++piece) {
    const long double begin = tau / pieces * piece, length = tau / pieces;
    std::array<std::array<long double, 2>, columns> table{};
    for (int k = 0; k < columns; ++k) {
      const int steps = 2 * (k + 1);
      const long double h = length / steps;
      std::array<long double, 2> before = at;
      std::array<long double, 2> now{at[0] + h * at[1], at[1] + h * acceleration(begin, at[0])};
      for (int i = 1; i < steps; ++i) {
        const std::array<long double, 2> next{before[0] + 2.0L * h * now[1],
                                              before[1] + 2.0L * h * acceleration(begin + i * h, now[0])};
        before = now;
        now = next;
      }
      std::array<long double, 2> row = now;
      for (int j = 1; j <= k; ++j) {  // Aitken and Neville, in h^2
        const long double ratio = static_cast<long double>(steps) / (2.0L * (k + 1 - j));
        for (std::size_t i = 0; i < 2; ++i) {
          const long double finer = row[i];
          row[i] = finer + (finer - table[static_cast<std::size_t>(j - 1)][i]) / (ratio * ratio - 1.0L);
          table[static_cast<std::size_t>(j - 1)][i] = finer;
        }
      }
      table[static_cast<std::size_t>(k)] = row;
    }
    at = table[columns - 1];
  }
  return at;
}

// A block that starts near balance takes longer than a period to fall back: the state at strobe instants within the hop.
TEST(VerticalHarmonic, MovesARockingBlockAsAnIndependentIntegratorSays) {
  for (const double frequency : {20.0, 10.0, 5.0, 14.142135623730951}) {
    for (const double height : {1.5, 4.0}) {
      Condition condition = shaken_both_ways(1.5, sine_of(0.8, frequency, 1.1));
      condition.scene.block.height = height;
      condition.scene.initial.tilt = 0.7;
      const auto block = dynamics::geometry_of(mean_block(condition.scene));
      const auto acceleration = [&](long double tau, long double theta) {
        const long double phi = static_cast<long double>(block.shape_angle) - theta;
        const long double alpha = 1.5L * block.shape_angle * std::sin(10.0L * tau + static_cast<long double>(0.4));
        const long double weight = 1.0L + 0.8L * std::sin(frequency * tau + static_cast<long double>(1.1));
        return -weight * std::sin(phi) + alpha * std::cos(phi);
      };
      const Trajectory trajectory = run(condition, 2);
      const long double tau = std::numbers::pi_v<long double> / 5.0L;
      ASSERT_TRUE(trajectory.events.empty() || trajectory.events[0].tau > static_cast<double>(tau));
      const std::array<long double, 2> start{static_cast<long double>(0.7 * block.shape_angle), 0.0L};
      const auto end = hop(start, tau, 64, acceleration);
      const auto coarse = hop(start, tau, 32, acceleration);
      ASSERT_NEAR(static_cast<double>(end[0] - coarse[0]), 0.0, 1e-16) << "the integrator has converged";
      EXPECT_NEAR(trajectory.strobe.at(0).tilt * block.shape_angle, static_cast<double>(end[0]), 2e-15) << frequency;
      EXPECT_NEAR(trajectory.strobe[0].tilt_rate * block.shape_angle, static_cast<double>(end[1]), 1e-14) << frequency;
    }
  }
}

/// The same motion of the base as samples, linear between them.
Condition sampled(const Condition& condition, int per_period, double amplitude, double vertical, double frequency) {
  Condition other = condition;
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  GroundMotion motion{.samples = {}, .has_vertical = true};
  for (int i = 0; i <= 7 * per_period; ++i) {
    const double tau = 0.2 * pi * i / per_period;
    motion.samples.push_back({tau / block.frequency_parameter,
                              amplitude * block.shape_angle * std::sin(10.0 * tau + 0.4),
                              vertical * std::sin(frequency * tau + 1.1)});
  }
  other.scene.excitation = support::recorded_by(std::move(motion), 10.0);
  return other;
}

// Linear interpolation changes the motion by the square of the spacing, with lifts, impacts, slip and stops.
TEST(VerticalHarmonic, IsTheLimitOfASampledSine) {
  for (const auto& friction :
       {std::optional<Friction>{}, std::optional(Friction{0.35, 0.3}), std::optional(Friction{0.22, 0.2})}) {
    for (const double frequency : {20.0, 5.0, 16.0}) {
      const Condition exact = shaken_both_ways(3.0, sine_of(0.5, frequency, 1.1), friction);
      const Trajectory wanted = run(exact, 6);
      std::array<double, 2> difference{};
      for (const int finer : {0, 1}) {
        const Trajectory found = run(sampled(exact, 400 << finer, 3.0, 0.5, frequency), 6);
        const auto &a = wanted.strobe.back(), &b = found.strobe.back();
        difference[static_cast<std::size_t>(finer)] = std::abs(a.tilt - b.tilt) + std::abs(a.tilt_rate - b.tilt_rate) +
                                                      std::abs(a.slip - b.slip) + std::abs(a.slip_rate - b.slip_rate);
        std::size_t i = 0;
        for (; i < std::min(wanted.events.size(), found.events.size()); ++i) {
          if (wanted.events[i].kind == EventKind::impact_stick && std::abs(wanted.events[i].tilt_rate) < 1e-3) break;
          EXPECT_EQ(wanted.events[i].kind, found.events[i].kind) << i;
          EXPECT_NEAR(wanted.events[i].tau, found.events[i].tau, 2e-3);
        }
        EXPECT_GT(i, 2U);
      }
      EXPECT_LT(difference[0], 2e-2) << frequency;
      EXPECT_NEAR(difference[0] / difference[1], 4.0, 0.4) << frequency << " " << friction.has_value();
    }
  }
}

// The vertical motion does work on the block; nothing else is left in the balance.
TEST(VerticalHarmonic, BalancesEnergy) {
  for (const auto& friction : {std::optional<Friction>{}, std::optional(Friction{0.35, 0.3})}) {
    Condition condition = shaken_both_ways(4.0, sine_of(0.6, 20.0, 1.1), friction);
    condition.scene.block.mass = GivenEdges{.edges = {0.45, 0.55}, .centre_height = 1.9, .radius_of_gyration = 1.1};
    const Trajectory trajectory = run(condition, 30);
    EXPECT_GT(trajectory.events.size(), 20U);
    EXPECT_NEAR(trajectory.energy.unaccounted(), 0.0, 3e-12);
  }
}

// The map of orbits begins where the horizontal sine is 0: the vertical motion is where it is then.
TEST(VerticalHarmonic, IsInStepOnThePoincareSection) {
  Condition condition = shaken_both_ways(4.0, sine_of(0.5, 20.0, 1.1));
  condition.horizon = {.transient_periods = 20, .sampled_periods = 10};
  const RealisationResult result = realise(condition, 0, 0);
  const PoincareMap map(condition);
  ASSERT_GT(result.strobe.size(), 3U);
  for (std::size_t k = 0; k + 1 < result.strobe.size(); ++k) {
    const auto image = map.image(result.strobe[k], 1);
    ASSERT_TRUE(image);
    EXPECT_NEAR(image->end().tilt, result.strobe[k + 1].tilt, 1e-11) << k;
    EXPECT_NEAR(image->end().tilt_rate, result.strobe[k + 1].tilt_rate, 1e-11) << k;
  }
}

// A motion that moves twice as fast vertically repeats after half a period, mirrored; one as fast does not.
TEST(VerticalHarmonic, HasAMirrorImageOnlyWithAnEvenRatio) {
  const auto scene = [](double frequency) { return shaken_both_ways(4.0, sine_of(0.5, frequency, 1.1)).scene; };
  EXPECT_TRUE(has_mirror_symmetry(scene(20.0)));
  EXPECT_FALSE(has_mirror_symmetry(scene(10.0)));
  EXPECT_FALSE(has_mirror_symmetry(scene(5.0)));
  EXPECT_FALSE(has_mirror_symmetry(scene(20.000001)));
  EXPECT_EQ(periods_of_base(scene(20.0)), 1);
  EXPECT_EQ(periods_of_base(scene(2.5)), 4);
  EXPECT_EQ(periods_of_base(scene(15.0)), std::nullopt);
  // Of several, each of which would do alone: after the periods of all.
  const auto one_of = [&scene](std::vector<double> ratios) {
    Scene drawn = scene(20.0);
    support::harmonic(drawn).vertical->frequency_ratio = rocking::Values{.values = std::move(ratios)};
    return periods_of_base(drawn);
  };
  EXPECT_EQ(one_of({10.0, 20.0}), 1);
  EXPECT_EQ(one_of({20.0, 2.5, 10.0 / 6.0}), 12);
  EXPECT_EQ(one_of({20.0, 15.0}), std::nullopt);
  EXPECT_EQ(periods_of_base(support::shaken(4.0).scene), 1);
  // The mirrored half is the map: an even ratio makes half a period, mirrored, twice the whole.
  const PoincareMap map(shaken_both_ways(4.0, sine_of(0.5, 20.0, 1.1)));
  const section::StrobePoint from{.tilt = 0.3, .tilt_rate = -0.2, .slip_rate = 0.0};
  const auto half = map.mirrored_half(from, 1);
  ASSERT_TRUE(half);
  const auto again = map.mirrored_half(half->end(), 1);
  const auto whole = map.image(from, 1);
  ASSERT_TRUE(again && whole);
  EXPECT_NEAR(again->end().tilt, whole->end().tilt, 1e-12);
  EXPECT_NEAR(again->end().tilt_rate, whole->end().tilt_rate, 1e-12);
}

}  // namespace
}  // namespace rocking
