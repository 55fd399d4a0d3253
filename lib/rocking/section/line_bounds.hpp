#pragma once

#include <array>
#include <limits>
#include <span>

#include "rocking/section/line_neighbourhood.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Bounds of a number that line_chance (spectral_line.hpp) returns, as it is rounded there. They are infinite where
/// rounding may change the sign of a determinant: the number may then be negative or NaN.
struct ChanceBounds {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Bounds of line_chance of all tested lines, in the order of tested_lines. They come from the same Fourier sums,
/// computed for all lines together (nearby_sums.hpp) in about a tenth of the operations. Lines whose denominator
/// divides n are not tested; their bounds, and those of fewer than 48 points, are infinite.
[[nodiscard]] std::array<ChanceBounds, line_count> chance_bounds(std::span<const PlanePoint> deviations, int n,
                                                                 double resolution);

}  // namespace rocking::section
