// A block with unequal edges and a moment of inertia of its own on a base at rest, against closed forms in SI units:
// about an edge it is a compound pendulum, upside down.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "analytic/motion.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

constexpr double gravity = 9.81;

/// In metres.
struct Body {
  double left;
  double right;
  double height;
  double gyration;  ///< radius, about the centre of mass
};

constexpr Body bodies[] = {
    {.left = 0.35, .right = 0.2, .height = 1.1, .gyration = 0.55},
    {.left = 0.15, .right = 0.6, .height = 0.9, .gyration = 0.3},  // Housner's ratio of the left edge: 0.91
    {.left = 0.5, .right = 0.55, .height = 2.5, .gyration = 1.9},  // heavy at its ends
};

/// Of the edge on a side (+1: left), as of a pendulum about it.
struct Pivot {
  double radius;     ///< R_S, edge to centre of mass [m]
  double angle;      ///< psi [rad]
  double frequency;  ///< sqrt(m g R_S/(I + m R_S^2)) [rad/s]
  double ratio;      ///< of the rates when this edge lands: the angular momentum about it is conserved
};

Pivot pivot_of(const Body& body, double side) {
  const double own = side > 0.0 ? body.left : body.right;
  const double other = side > 0.0 ? body.right : body.left;
  const double central = body.gyration * body.gyration + body.height * body.height;
  return {.radius = std::hypot(own, body.height),
          .angle = std::atan(own / body.height),
          .frequency = std::sqrt(gravity * std::hypot(own, body.height) / (central + own * own)),
          .ratio = (central - own * other) / (central + own * own)};
}

/// Released on this side at the angle phi of the line from the edge to the centre of mass, with its rate phi'.
Condition released(const Body& body, double side, double phi, double phi_rate = 0.0) {
  Condition condition;
  Scene& scene = condition.scene;
  support::harmonic(scene).frequency_ratio = 10.0;
  scene.block.gravity = gravity;
  scene.block.mass =
      GivenEdges{.edges = {body.left, body.right}, .centre_height = body.height, .radius_of_gyration = body.gyration};
  const double psi = pivot_of(body, side).angle;
  const double p = dynamics::geometry_of(mean_block(scene)).frequency_parameter;
  scene.initial = {.tilt = side * (1.0 - phi / psi), .tilt_rate = -side * phi_rate / (psi * p)};
  return condition;
}

/// The angle phi at the first strobe point, at tau = pi/5, and its time in seconds.
struct Later {
  double phi;
  double seconds;
};

Later after_a_period(const Condition& condition, const Pivot& pivot) {
  const Trajectory trajectory = run(condition, 1);
  const double p = dynamics::geometry_of(mean_block(condition.scene)).frequency_parameter;
  EXPECT_TRUE(trajectory.events.empty());
  return {pivot.angle * (1.0 - std::abs(trajectory.strobe.at(0).tilt)), 0.2 * pi / p};
}

// phi'' = P^2 sin(phi) = P^2 phi (1 - O(phi^2)): about its balance a block moves as cosh(P t), and with phi' = +-P phi as
// exp(+-P t).
TEST(UnequalEdges, DepartFromBalanceAndApproachItWithTheFrequencyOfTheirSide) {
  for (const Body& body : bodies) {
    for (const double side : {1.0, -1.0}) {
      const Pivot pivot = pivot_of(body, side);
      for (const double share : {0.0, 1.0, -1.0}) {
        const auto error_from = [&](double phi) {
          const auto [found, t] = after_a_period(released(body, side, phi, share * pivot.frequency * phi), pivot);
          const double growth = share == 0.0 ? std::cosh(pivot.frequency * t) : std::exp(share * pivot.frequency * t);
          return found / (phi * growth) - 1.0;
        };
        EXPECT_LT(std::abs(error_from(0.01)), 1e-4);
        EXPECT_NEAR(error_from(0.01) / error_from(0.005), 4.0, 0.01) << "of second order; edge " << side;
      }
    }
  }
}

// A small tilt theta falls at the constant acceleration P^2 sin(psi): in sqrt(2 theta/(P^2 sin(psi))), (1 + O(theta)).
TEST(UnequalEdges, FallFromASmallTiltAtTheAccelerationOfTheirSide) {
  for (const Body& body : bodies) {
    for (const double side : {1.0, -1.0}) {
      const Pivot pivot = pivot_of(body, side);
      const auto error_from = [&](double tilt) {
        const Condition condition = released(body, side, pivot.angle - tilt);
        const double p = dynamics::geometry_of(mean_block(condition.scene)).frequency_parameter;
        const double time = run(condition, 1).events.at(0).tau / p;
        return time * pivot.frequency * std::sqrt(std::sin(pivot.angle) / (2.0 * tilt)) - 1.0;
      };
      EXPECT_LT(std::abs(error_from(1e-4)), 1e-3);
      EXPECT_NEAR(error_from(1e-4) / error_from(5e-5), 2.0, 0.01) << "of first order; edge " << side;
    }
  }
}

/// Seconds in which a block at rest at phi0 falls on its base. By energy phi'^2 = 2 P^2 (cos(phi0) - cos(phi)); with
/// phi = phi0 + u^2 the time is an integral of a smooth function.
double quarter(const Pivot& pivot, double phi0) {
  const auto slowness = [phi0](double u) {
    const double half = 0.5 * u * u;
    return u / std::sqrt(std::sin(phi0 + half) * std::sin(half));
  };
  const double whole = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      slowness, 0.0, std::sqrt(pivot.angle - phi0), 4, 1e-14);
  return whole / pivot.frequency;
}

// Housner's free rocking: between impacts energy is conserved, an impact multiplies the rate by the ratio of the edge
// that lands, and the quarters of the two sides alternate.
TEST(UnequalEdges, RockFreelyAsTheQuarterPeriodsOfBothSidesSay) {
  for (const Body& body : bodies) {
    for (const double first : {1.0, -1.0}) {
      const Pivot sides[] = {pivot_of(body, first), pivot_of(body, -first)};
      // It rises by 0.7 of what overturns it over the nearer edge.
      const double highest = 0.3 * body.height + 0.7 * std::min(sides[0].radius, sides[1].radius);
      double phi0 = std::acos(highest / sides[0].radius);
      const Condition condition = released(body, first, phi0);
      const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
      const double p = block.frequency_parameter;
      const Trajectory trajectory = run(condition, 60);
      double time = quarter(sides[0], phi0);
      for (std::size_t n = 0; n < 12; ++n) {
        const Pivot& falls = sides[n % 2];
        const Pivot& rises = sides[(n + 1) % 2];
        const double arrives = falls.frequency * std::sqrt(2.0 * (std::cos(phi0) - std::cos(falls.angle)));
        const double leaves = rises.ratio * arrives;
        const TrajectoryEvent& impact = trajectory.events.at(n);
        // Events of the library are exact to about 1e-13; impacts add up their errors.
        EXPECT_NEAR(impact.tau / p, time, 1e-12) << "impact " << n << ", first edge " << first;
        EXPECT_NEAR(std::abs(impact.tilt_rate) * p * rises.angle, leaves, 1e-12) << "impact " << n;
        EXPECT_EQ(impact.tilt_rate < 0.0, (n % 2 == 0) == (first > 0.0)) << "impact " << n;
        phi0 = std::acos(std::cos(rises.angle) + 0.5 * std::pow(leaves / rises.frequency, 2));
        time += 2.0 * quarter(rises, phi0);
      }
    }
  }
}

}  // namespace
}  // namespace rocking
