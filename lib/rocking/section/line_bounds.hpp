#pragma once

#include <array>
#include <limits>
#include <span>

#include "rocking/section/plane.hpp"

namespace rocking::section {

/// A reduced fraction of the excitation frequency, in (0, 1/2].
struct LineFrequency {
  int numerator = 0;
  int denominator = 1;
};

/// Number of reduced fractions j/q in (0, 1/2] with q <= 12: the tested lines.
inline constexpr int line_count = 23;

/// The tested lines, by denominator and numerator.
[[nodiscard]] std::span<const LineFrequency, line_count> tested_lines();

/// Bounds of a chance that strongest_line computes. They are infinite if rounding may change the sign of a determinant;
/// the chance may then be negative or NaN.
struct ChanceBounds {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Bounds of the chances of all lines, each from the same Fourier sums as the chance itself, but computed for all lines
/// together: about a tenth of the operations. The bounds contain the chance as it is rounded. Lines whose denominator
/// divides n are not tested; their entries have no meaning.
///
/// With Q a multiple of the denominator q, the points k = Q a + b are summed first over a, at the frequencies s/L of a
/// series of L points (s = 0 ... of the neighbourhood), then over b, at j/q + s/L and j/q - s/L. The first sums serve
/// all lines with the same L whose denominators divide Q.
[[nodiscard]] std::array<ChanceBounds, line_count> chance_bounds(std::span<const PlanePoint> deviations, int n,
                                                                 double resolution);

}  // namespace rocking::section
