#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <boost/math/special_functions/ellint_1.hpp>

#include "rocking/realisation/trajectory.hpp"

/// Helpers to compare motions with closed forms.
namespace rocking {

inline constexpr double pi = std::numbers::pi;

inline Trajectory run(const Condition& condition, std::int64_t periods) {
  return trajectory_of(condition, 0, 0, periods);
}

/// Time in which a block released at rest at the angle phi0 from the vertical falls to phi; on its base, phi = psi.
///
/// phi'' = sin(phi) is a pendulum about its upper equilibrium. With k = cos(phi0/2) and sin(chi) = cos(phi/2)/k the
/// time from phi0 to phi is K(k) - F(chi, k).
inline double falling_time(double phi0, double phi) {
  const double k = std::cos(0.5 * phi0);
  return boost::math::ellint_1(k) - boost::math::ellint_1(k, std::asin(std::cos(0.5 * phi) / k));
}

}  // namespace rocking
