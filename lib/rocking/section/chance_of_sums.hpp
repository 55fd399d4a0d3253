#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "rocking/section/nearby_sums.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Relative error of one rounding.
inline constexpr double rounding_unit = 0.5 * std::numeric_limits<double>::epsilon();

/// Bounds of a number that line_chance (line_bounds.hpp) returns, as it is rounded there. They are infinite where
/// rounding may change the sign of a determinant: the number may then be negative or NaN.
struct ChanceBounds {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The Fourier sum of a line, sums of squares and products of those of its neighbours, and bounds of the errors of the
/// Fourier sums.
struct LineSums {
  Covariance noise;
  double floor = 0.0;  ///< what the resolution adds to `noise`
  Amplitude own;
  std::size_t neighbours = 0;
  bool at_half = false;
  double error_x = 0.0;
  double error_y = 0.0;
};

/// Bounds of the chances of some lines; there are as many `bounds`, or more. If rounding is certain, both bounds are the
/// number that line_chance returns.
void set_bounds(std::span<const LineSums> lines, std::span<ChanceBounds> bounds);

}  // namespace rocking::section
