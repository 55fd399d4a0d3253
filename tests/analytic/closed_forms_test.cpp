// Trajectories with a closed form: elliptic integrals, exponentials, parabolas.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;

/// The reference block on a base at rest, without friction.
Condition still(double tilt, double height = 4.0) {
  Condition condition;
  condition.scene.block.height = height;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.initial.tilt = tilt;
  return condition;
}

TEST(FreeRocking, FallsBackInTheTimeOfTheEllipticIntegral) {
  for (const double height : {1.0, 2.0, 4.0, 10.0}) {
    for (const double tilt : {0.05, 0.3, 0.7, 0.95}) {
      const Condition condition = still(tilt, height);
      const double psi = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
      const Trajectory trajectory = run(condition, 20);
      ASSERT_FALSE(trajectory.events.empty());
      const double time = falling_time(psi * (1.0 - tilt), psi);
      // The rounding of k, 2^-53, is multiplied by dK/dk, about 4/phi0^2; the difference of the integrals loses a
      // factor 1/tilt.
      const double phi0 = psi * (1.0 - tilt);
      EXPECT_NEAR(trajectory.events[0].tau, time, 1e-15 / (phi0 * phi0) + 1e-14 / tilt) << height << " " << tilt;
    }
  }
}

// psi -> 0: Theta'' = Theta - 1 for Theta > 0, so Theta = 1 - (1 - Theta0) cosh(tau); quarter period arcosh(1/(1 -
// Theta0)).
TEST(SlenderBlock, FollowsHousnersLinearSolution) {
  const double start = 0.4;
  double last_error = 1.0;
  for (const double height : {50.0, 100.0, 200.0}) {
    const Trajectory trajectory = run(still(start, height), 2);
    const double tau = 0.2 * pi;  // before the first impact
    const double exact = 1.0 - (1.0 - start) * std::cosh(tau);
    const double error = std::abs(trajectory.strobe.at(0).tilt - exact);
    EXPECT_LT(error, 1.0 / (height * height)) << "of second order in psi";
    EXPECT_NEAR(last_error / error, 4.0, last_error == 1.0 ? 1e9 : 0.05) << "H/B = " << height;
    last_error = error;
    EXPECT_NEAR(trajectory.events.empty() ? std::acosh(1.0 / (1.0 - start)) : trajectory.events[0].tau,
                std::acosh(1.0 / (1.0 - start)), 1.0 / (height * height));
  }
}

// Each impact keeps delta^2 of the energy. With 1 - cos as potential: cos(phi_n) - cos(psi) = delta^2 (cos(phi_{n-1}) -
// cos(psi)).
TEST(FreeRocking, LosesAtEachImpactTheShareOfTheEnergyThatHousnerSays) {
  const Condition condition = still(0.8);
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  const double delta = 1.0 - 1.5 * block.sine * block.sine;
  const Trajectory trajectory = run(condition, 60);
  double energy = std::cos(0.2 * block.shape_angle) - block.cosine;
  double tau = falling_time(0.2 * block.shape_angle, block.shape_angle);
  for (std::size_t n = 0; n < 12; ++n) {
    energy *= delta * delta;
    EXPECT_NEAR(std::abs(trajectory.events.at(n).tilt_rate) * block.shape_angle, std::sqrt(2.0 * energy), 1e-12) << n;
    EXPECT_NEAR(trajectory.events[n].tau, tau, 2e-12) << n;
    tau += 2.0 * falling_time(std::acos(block.cosine + energy), block.shape_angle);
  }
}

// With a ratio of each edge, delta of an impact is that of the edge that lands: the left one at the first impact from a
// negative tilt.
TEST(FreeRocking, LosesAtEachImpactTheMeasuredShareOfTheEdgeThatLands) {
  Condition condition = still(-0.8);
  condition.scene.restitution = RateRatio{.value = 0.97, .right = 0.91};
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  const Trajectory trajectory = run(condition, 60);
  double energy = std::cos(0.2 * block.shape_angle) - block.cosine;
  for (std::size_t n = 0; n < 12; ++n) {
    const double delta = n % 2 == 0 ? 0.97 : 0.91;
    energy *= delta * delta;
    EXPECT_NEAR(std::abs(trajectory.events.at(n).tilt_rate) * block.shape_angle, std::sqrt(2.0 * energy), 1e-12) << n;
  }
}

// Energy and half-periods stay: falling_time from the same height each time. An error of the energy that each half-period
// adds, some ten steps of 1e-13, changes all later ones: their sum grows with the square of their number.
TEST(FreeRocking, GoesOnForeverAtARateRatioOfOne) {
  Condition condition = still(-0.8);
  condition.scene.restitution = RateRatio{.value = 1.0};
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  const Trajectory trajectory = run(condition, 1000);
  const double rate = std::sqrt(2.0 * (std::cos(0.2 * block.shape_angle) - block.cosine));
  const double quarter = falling_time(0.2 * block.shape_angle, block.shape_angle);
  ASSERT_GT(trajectory.events.size(), 100U);
  for (std::size_t n = 0; n < 100; ++n) {
    EXPECT_NEAR(std::abs(trajectory.events[n].tilt_rate) * block.shape_angle, rate, 1e-11) << n;
    EXPECT_NEAR(trajectory.events[n].tau, (2.0 * static_cast<double>(n) + 1.0) * quarter,
                2e-12 * static_cast<double>((n + 1) * (n + 1)))
        << n;
  }
}

// X goes on from the displacement at the start, which counts for its peak.
TEST(Sliding, BeginsAtTheInitialSlip) {
  Condition condition = still(0.0);
  condition.scene.friction = Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.2};
  condition.scene.initial = {.slip = -0.3, .slip_rate = 0.1, .units = {.slip = StateUnit::si}};
  const Trajectory trajectory = run(condition, 60);
  const double start = -0.3 / dynamics::geometry_of(mean_block(condition.scene)).half_diagonal;
  const double end = start + 0.1 * 0.1 / (2.0 * 0.2 * 4.0 / 3.0);
  EXPECT_EQ(trajectory.strobe.at(0).contact, dynamics::ContactState::rest);
  EXPECT_NEAR(trajectory.strobe[0].slip, end, 1e-14);
  const RealisationResult result = realise(condition, 0, 0);
  EXPECT_NEAR(result.peaks.final_slip, end, 1e-14);
  EXPECT_EQ(result.peaks.slip, -start);
}

/// Phase and amplitude such that the peak base acceleration is tan(psi), as nearly as doubles allow.
Condition at_threshold(double factor) {
  Condition condition = still(0.0);
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  support::harmonic(condition.scene).amplitude = block.tangent / block.shape_angle * factor;
  return condition;
}

// At the threshold the peak only touches it. Slightly above, the block rocks while the sine exceeds the threshold, for
// sqrt(8 * excess)/Omega: an excess of 1e-12 is still visible above rounding.
// Unchecked, since an experiment file allows no negative amplitude.
TEST(StaticThreshold, IsTheSmallestAmplitudeThatLifts) {
  EXPECT_NEAR(mean_of(support::harmonic(at_threshold(1.0).scene).amplitude), 1.0205, 5e-5) << "for H/B = 4";
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(trajectory_of_unchecked(at_threshold(sign * (1.0 - 1e-15)), 0, 0, 50).events.empty());
    for (const double excess : {1e-12, 1e-9, 1e-6}) {
      const Trajectory trajectory = trajectory_of_unchecked(at_threshold(sign * (1.0 + excess)), 0, 0, 1);
      ASSERT_FALSE(trajectory.events.empty()) << excess;
      EXPECT_EQ(trajectory.events[0].kind, EventKind::lift);
      const double early = std::sqrt(2.0 * excess) / 10.0;
      EXPECT_NEAR(trajectory.events[0].tau, 0.05 * pi - early, 0.05 * early) << excess;
    }
  }
}

/// Slides from the start at `slip_rate`, on a base with the peak acceleration `peak` [g].
Condition sliding(double slip_rate, double peak, double phase) {
  Condition condition = still(0.0);
  condition.scene.friction = Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.15};
  condition.scene.initial.slip_rate = slip_rate;
  support::harmonic(condition.scene).phase = phase;
  support::harmonic(condition.scene).amplitude = peak / dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
  return condition;
}

// V = V0 - (4/3)(mu_k s tau + (A/Omega)(cos(Phi) - cos(Omega tau + Phi))) while V keeps its sign.
TEST(Sliding, FollowsItsClosedFormUnderHarmonicShaking) {
  for (const double direction : {1.0, -1.0}) {
    for (const double phase : {0.0, 1.0, 4.0}) {
      const double peak = 1.7;
      const double start = direction * 3.0;
      const Trajectory trajectory = run(sliding(start, peak, phase), 10);
      ASSERT_TRUE(trajectory.events.empty()) << "it slides on";
      for (const auto& sample : trajectory.strobe) {
        const double tau = 0.2 * pi * static_cast<double>(sample.period);
        // After a whole number of periods the cosines cancel; only the drift of the base motion remains in X.
        const double rate = start - 4.0 / 3.0 * 0.15 * direction * tau;
        const double slip =
            start * tau - 2.0 / 3.0 * 0.15 * direction * tau * tau - 4.0 / 3.0 * peak / 10.0 * std::cos(phase) * tau;
        EXPECT_NEAR(sample.slip_rate, rate, 2e-13) << sample.period;
        EXPECT_NEAR(sample.slip, slip, 2e-12) << sample.period;
        EXPECT_EQ(sample.contact, dynamics::ContactState::slide);
      }
    }
  }
}

// On a base at rest V = V0 - (4/3) mu_k s tau: the block stops after the time 3 abs(V0)/(4 mu_k) and the distance V0^2
// 3/(8 mu_k), and stays there.
TEST(Sliding, StopsOnAStillBaseWhereAndWhenConstantFrictionSays) {
  for (const double start : {2.0, -0.5, 1e-3, -1e-9}) {
    const Trajectory trajectory = run(sliding(start, 0.0, 0.0), 40);
    ASSERT_EQ(trajectory.events.size(), 1U);
    const TrajectoryEvent& stop = trajectory.events[0];
    EXPECT_EQ(stop.kind, EventKind::slide_stop);
    // Each of about twenty steps rounds tau and X once; the root has the resolution of the time, 2^-49 of a period.
    EXPECT_NEAR(stop.tau, 0.75 * std::abs(start) / 0.15, 20.0 * 0x1p-52 * stop.tau + 0x1p-49 * 0.2 * pi) << start;
    EXPECT_NEAR(stop.slip, 0.375 * start * std::abs(start) / 0.15, 40.0 * 0x1p-52 * std::abs(stop.slip)) << start;
    EXPECT_EQ(stop.slip_rate, 0.0);
    EXPECT_EQ(trajectory.strobe.back().slip, stop.slip) << "it stays where it stopped";
    EXPECT_EQ(trajectory.strobe.back().contact, dynamics::ContactState::rest);
  }
}

// Without friction no horizontal force acts on the block. Its centre of mass keeps a constant speed in space through
// rocking, slipping and impacts, whatever the base does. In the frame of the base its speed is V - w cos(phi), its
// position X + S (sin(phi) - sin(psi)), and the drift of the base over whole periods -(4/3) (A/Omega) cos(Phi).
TEST(FrictionlessRocking, LeavesItsCentreOfMassToItself) {
  for (const double height : {1.5, 4.0, 10.0}) {
    for (const double phase : {0.0, 0.7, 3.0}) {
      Condition condition = still(0.7, height);
      condition.scene.friction = Friction{.static_coefficient = 0.0, .kinetic_coefficient = 0.0};
      support::harmonic(condition.scene).phase = phase;
      support::harmonic(condition.scene).amplitude = 4.0;
      condition.scene.initial.tilt_rate = 0.3;
      condition.scene.initial.slip_rate = 0.2;
      const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
      const auto speed = [&block](double tilt, double rate, double slip_rate) {
        return slip_rate - rate * block.shape_angle * std::cos(block.shape_angle * (1.0 - std::abs(tilt)));
      };
      const auto place = [&block](double tilt, double slip) {
        const double moved = std::sin(block.shape_angle * (1.0 - std::abs(tilt))) - block.sine;
        return slip + (tilt < 0.0 ? -moved : moved);
      };
      const double v0 = speed(0.7, 0.3, 0.2);
      const double drift = -4.0 / 3.0 * 4.0 * block.shape_angle / 10.0 * std::cos(phase);
      const Trajectory trajectory = run(condition, 10);
      EXPECT_TRUE(std::any_of(trajectory.events.begin(), trajectory.events.end(),
                              [](const auto& event) { return event.kind == EventKind::impact_slip; }));
      for (const TrajectorySample& sample : trajectory.strobe) {
        const double tau = 0.2 * pi * static_cast<double>(sample.period);
        if (sample.contact != dynamics::ContactState::rock_slide) break;  // the end of a chatter neglects a hop
        EXPECT_NEAR(speed(sample.tilt, sample.tilt_rate, sample.slip_rate), v0, 1e-13)
            << height << " " << sample.period;
        EXPECT_NEAR(place(sample.tilt, sample.slip), place(0.7, 0.0) + (v0 + drift) * tau, 1e-13)
            << height << " " << sample.period;
      }
    }
  }
}

// Strong excitation, weak friction: the block slides back and forth for ever. In the steady motion with mu_k > 0,
// reversals occur where the impulses of friction and base cancel: V = 0 at each, exactly half a period apart.
TEST(Sliding, SettlesToReversalsHalfAPeriodApart) {
  Condition condition = sliding(0.0, 1.7, 0.0);
  const Trajectory trajectory = run(condition, 90);
  std::vector<double> reversals;
  for (const auto& event : trajectory.events) {
    if (event.kind == EventKind::slip_reverse) reversals.push_back(event.tau);
  }
  ASSERT_GT(reversals.size(), 60U);
  const std::size_t n = reversals.size();
  EXPECT_NEAR(reversals[n - 1] - reversals[n - 2], 0.1 * pi, 1e-10);
  // Between reversals at u and u + pi: 2 A cos(u) = mu_k pi, with cos > 0 where the block begins to lag behind.
  EXPECT_NEAR(std::abs(std::cos(10.0 * reversals[n - 1])), 0.15 * pi / (2.0 * 1.7), 1e-9);
}

// Free rocking is not affected by a base that moves uniformly: with alpha = 0 the frequency has no effect.
TEST(FreeRocking, DoesNotDependOnTheFrequencyOfABaseThatStandsStill) {
  Condition slow = still(0.5);
  support::harmonic(slow.scene).frequency_ratio = 5.0;
  const Trajectory a = run(still(0.5), 10);
  const Trajectory b = run(slow, 5);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) EXPECT_NEAR(a.events[i].tau, b.events[i].tau, 1e-13);
}

}  // namespace
}  // namespace rocking
