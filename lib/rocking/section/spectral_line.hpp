#pragma once

#include <optional>
#include <span>

#include "rocking/section/plane.hpp"

namespace rocking::section {

/// A frequency numerator/denominator per period at which deviations may have a line.
struct Line {
  int numerator = 0;
  int denominator = 1;
  double chance = 1.0;  ///< probability that noise without a line stands out this far of its neighbourhood
};

/// Number of reduced fractions j/q in (0, 1/2] with q <= 12: the lines that are looked for.
inline constexpr int line_count = 23;

/// The line that stands out most, of all j/q with 2 <= q <= 12 and q no divisor of n; nothing if there is none to test.
///
/// At the frequency of the line the real and imaginary part of the Fourier sum of (x, y) make a matrix H of sums of
/// squares and products with 2 degrees of freedom (1 at frequency 1/2); the M nearest frequencies one make a
/// matrix E with 2M. Under noise whose spectrum is smooth over these frequencies and by approximation normal,
/// L = sqrt(det E/det(E + H)) is Beta(2M - 1, 2) distributed (Wilks 1932; Anderson, Multivariate Analysis, 8.4):
///
///     P(L <= y) = y^(2M-1) (2M - (2M - 1) y),   at frequency 1/2: y^(2M-1)
///
/// Being measured against its own neighbourhood, a line is told from the hump that slowly forgotten noise makes.
/// `deviations` are from the centres of classes k mod n.
[[nodiscard]] std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution);

}  // namespace rocking::section
