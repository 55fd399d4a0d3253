#pragma once

#include <optional>
#include <span>

#include "rocking/section/line_bounds.hpp"
#include "rocking/section/line_neighbourhood.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// A line and its chance.
struct Line {
  LineFrequency frequency;
  double chance = 1.0;
};

/// Probability that noise without a line exceeds its neighbourhood at this frequency as much as the deviations do.
///
/// The real and imaginary parts of the Fourier sum of (x, y) at the frequency of the line form a matrix H of sums of
/// squares and products with 2 degrees of freedom (1 at frequency 1/2). Those at the M nearest frequencies form a
/// matrix E with 2M. If the noise is approximately normal and its spectrum is smooth over these frequencies, L =
/// sqrt(det E/det(E + H)) has the law Beta(2M - 1, 2) (Wilks 1932; Anderson, Multivariate Analysis, 8.4):
///
///     P(L <= y) = y^(2M-1) (2M - (2M - 1) y),   at frequency 1/2: y^(2M-1)
///
/// Each line is compared with its own neighbourhood. It is therefore distinguished from the broad maximum of noise with
/// long memory. `deviations` are measured from the centres of the classes k mod n; n is no multiple of the denominator.
[[nodiscard]] double line_chance(const LineFrequency& line, std::span<const PlanePoint> deviations, int n,
                                 double resolution);

/// A number that no chance of a tested line is below.
[[nodiscard]] double least_chance(const AllChanceBounds& bounds, int n);

/// The line of least chance, if the bounds show which one it is and that its chance is below the limit.
[[nodiscard]] std::optional<LineFrequency> certain_line(const AllChanceBounds& bounds, int n, double limit);

/// The line of least chance of all j/q with 2 <= q <= 12 where q does not divide n, the first of equal ones; nothing if
/// there is none to test. line_chance is called only for lines that may have the least chance by the bounds.
[[nodiscard]] std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution,
                                                 const AllChanceBounds& bounds);

}  // namespace rocking::section
