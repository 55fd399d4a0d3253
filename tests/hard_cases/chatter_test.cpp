// Chatter: infinitely many impacts in finite time, from hops near the balance to hops below the tolerance. Times and
// positions are compared with closed forms.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;
using support::SplitMix;

/// A block under a constant base acceleration, without friction by default. Strobe points a time 1 apart.
Condition pushed(double height, double alpha, double tolerance) {
  Condition condition;
  condition.scene.block.height = height;
  condition.tolerance = tolerance;
  GroundMotion motion{.samples = {{0.0, alpha, 0.0}, {1e6, alpha, 0.0}}, .has_vertical = false};
  condition.scene.excitation = support::recorded_by(std::move(motion), 2.0 * std::numbers::pi);
  return condition;
}

/// Duration of a hop that starts at rate w on the edge S under a constant alpha.
///
/// Gravity is tilted by chi = atan(alpha) and larger by A = sqrt(1 + alpha^2). With gamma = phi - S chi the motion is
/// gamma'' = A sin(gamma), a pendulum whose rise and fall are symmetric. With the rate u as variable of integration, dt
/// = du/(A sin(gamma)) and A cos(gamma) = A cos(gamma0) + (w^2 - u^2)/2. For hops away from the balance this integral
/// has no singularity; Gauss's formula gives it to rounding.
long double hop_time(long double rate, long double side, long double alpha, long double psi) {
  const long double size = std::sqrt(1.0L + alpha * alpha);
  const long double ground = size * std::cos(psi - side * std::atan(alpha));
  const auto integrand = [&](long double u) {
    const long double along = ground + 0.5L * (rate * rate - u * u);
    return 1.0L / std::sqrt(size * size - along * along);
  };
  return 2.0L * boost::math::quadrature::gauss<long double, 30>::integrate(integrand, 0.0L, rate);
}

struct Chatter {
  double height;
  double alpha;
  double rate;  ///< Theta' at the start, over the left edge
};

// Each impact occurs at the time of the closed form, and the end differs from the limit of the series by no more than
// documented. The rate after a step has an error of at most the tolerance, 1e-13 psi. An error r of the rate changes
// the time of landing by 2 r/pull, pull = sin(psi) - abs(alpha) cos(psi), and all later ones by 1/(1 - delta) times as
// much. A hop has few steps, and only the first hops count: ten steps of full size are a bound.
TEST(ChatterToRest, HasEachImpactAtTheInstantOfTheClosedForm) {
  double worst = 0.0;
  for (const Chatter& scene : {Chatter{4.0, 0.0, 0.9}, Chatter{4.0, 0.0, 0.1}, Chatter{4.0, 0.1, 0.4},
                               Chatter{4.0, -0.2, 0.1}, Chatter{4.0, 0.24, 0.02}, Chatter{2.0, 0.3, 0.3},
                               Chatter{8.0, 0.06, 0.4}, Chatter{1.2, 0.5, 0.3}, Chatter{0.5, 0.9, 0.2}}) {
    const testing::ScopedTrace trace(
        __FILE__, __LINE__, "H/B = " + std::to_string(scene.height) + ", alpha = " + std::to_string(scene.alpha));
    const Condition condition = [&] {
      Condition made = pushed(scene.height, scene.alpha, 1e-13);
      made.scene.initial.tilt_rate = scene.rate;
      return made;
    }();
    const long double psi = std::atan(1.0L / static_cast<long double>(scene.height));
    const long double delta = 1.0L - 1.5L * std::sin(psi) * std::sin(psi);
    const Trajectory trajectory = trajectory_of(condition, 0, 0, 100);
    long double rate = scene.rate * psi;
    long double side = 1.0L;
    long double tau = 0.0L;
    std::size_t hops = 0;
    const double pull = static_cast<double>(std::sin(psi) - std::abs(scene.alpha) * std::cos(psi));
    const double slack = 10.0 * 2.0 * 1e-13 * static_cast<double>(psi / (1.0L - std::abs(delta))) / pull;
    for (; hops < trajectory.events.size() && trajectory.events[hops].kind == EventKind::impact_stick; ++hops) {
      tau += hop_time(rate, side, scene.alpha, psi);
      rate *= std::abs(delta);
      if (delta > 0.0L) side = -side;
      const double error = std::abs(trajectory.events[hops].tau - static_cast<double>(tau));
      ASSERT_LE(error, slack) << "impact " << hops;
      worst = std::max(worst, error / slack);
    }
    ASSERT_GT(hops, 10U);
    ASSERT_EQ(hops + 1, trajectory.events.size());
    const TrajectoryEvent& end = trajectory.events.back();
    EXPECT_EQ(end.kind, EventKind::to_rest);
    EXPECT_EQ(end.tau, trajectory.events[hops - 1].tau);
    const long double last = rate;
    for (; rate > 1e-30L; rate *= std::abs(delta), side = delta > 0.0L ? -side : side) {
      tau += hop_time(rate, side, scene.alpha, psi);
    }
    const auto documented = static_cast<double>(
        2.0L * last / ((1.0L - std::abs(delta)) * (std::sin(psi) - std::abs(scene.alpha) * std::cos(psi))));
    EXPECT_NEAR(end.tau, static_cast<double>(tau), documented + slack);
    EXPECT_LE(documented, 1e-13 / (1.0 - std::abs(static_cast<double>(delta))) * 2.0 /
                              (1.0 - std::abs(scene.alpha) * scene.height));
  }
  RecordProperty("worst", std::to_string(worst) + " of bound");
}

/// Time and position at which a block that chatters while it slides comes to rest on a base at rest.
struct Stop {
  long double tau;
  long double slip;
};

// Friction is mu_k times the normal force in every hop and every impact, as long as all of them slip in the same
// direction and the edges alternate. (An impact after which the block turns about the same edge follows a convention
// and has no impulse.) Then x + s mu_k y of the centre of mass moves as under a constant force, whatever the hops are.
// With x' = V - w cos(psi) and y' = abs(w) sin(psi) at the start, u = s (V - w cos(psi)) + mu_k abs(w) sin(psi) and the
// deceleration (4/3) mu_k, the block stops after the time u/((4/3) mu_k) and the distance u^2/((8/3) mu_k).
Stop stop_of(long double slip_rate, long double rate, long double mu_k, long double psi) {
  const long double sign = slip_rate < 0.0L ? -1.0L : 1.0L;
  const long double speed = sign * (slip_rate - rate * std::cos(psi)) + mu_k * std::abs(rate) * std::sin(psi);
  return {.tau = 0.75L * speed / mu_k, .slip = sign * 0.375L * speed * speed / mu_k};
}

// The end of the chatter neglects a last hop at rate w2: at most abs(w2) of the speed u, hence 0.75 abs(w2)/mu_k of the
// time. 2 abs(w2) is below the tolerance times the pull, which is below 1. Rounding and the error of steps add the
// tolerance again.
TEST(ChatterToSlide, StopsAtTheTimeAndPlaceOfTheClosedForm) {
  double worst = 0.0;
  int found = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SplitMix draw(seed);
    const double tolerance = std::pow(10.0, -draw.uniform(6.0, 13.0));
    Condition condition = pushed(draw.uniform(1.5, 6.0), 0.0, tolerance);
    const double psi = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
    const double mu = std::tan(psi) * draw.uniform(0.3, 0.8);
    condition.scene.friction = Friction{.static_coefficient = mu, .kinetic_coefficient = mu * draw.uniform(0.7, 1.0)};
    const double tilt_rate = draw.uniform(-0.3, 0.3);
    const double slip_rate = draw.uniform(0.8, 1.5) * (draw.below(2) == 0 ? 1.0 : -1.0);
    condition.scene.initial.tilt_rate = tilt_rate;
    condition.scene.initial.slip_rate = slip_rate;
    const Trajectory trajectory = trajectory_of(condition, 0, 0, 40);
    if (trajectory.events.empty() || trajectory.events.back().kind != EventKind::slide_stop) continue;
    bool is_one_way = trajectory.losses_of_contact == 0;
    double last = tilt_rate;
    for (const TrajectoryEvent& event : trajectory.events) {
      is_one_way = is_one_way && (event.slip_rate * slip_rate > 0.0 || event.kind == EventKind::slide_stop);
      if (event.kind == EventKind::impact_slip) is_one_way = is_one_way && event.tilt_rate * last < 0.0;
      if (event.kind == EventKind::impact_stick) is_one_way = false;
      last = event.tilt_rate;
    }
    if (!is_one_way) continue;
    ++found;
    const double mu_k = mean_kinetic(*condition.scene.friction);
    const Stop stop = stop_of(slip_rate, tilt_rate * psi, mu_k, psi);
    const TrajectoryEvent& end = trajectory.events.back();
    const double bound = (0.5 * tolerance + 1e-12) / mu_k;
    ASSERT_NEAR(end.tau, static_cast<double>(stop.tau), bound) << "seed " << seed << ", tolerance " << tolerance;
    ASSERT_NEAR(end.slip, static_cast<double>(stop.slip), 2.0 * bound) << "seed " << seed;
    worst = std::max(worst, std::abs(end.tau - static_cast<double>(stop.tau)) / bound);
  }
  EXPECT_GT(found, 100);
  RecordProperty("worst", std::to_string(worst) + " of bound, found " + std::to_string(found));
}

}  // namespace
}  // namespace rocking
