#pragma once

#include <optional>
#include <span>

#include "rocking/section/line_bounds.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// A frequency numerator/denominator, per period, at which deviations may have a spectral line.
struct Line {
  int numerator = 0;
  int denominator = 1;
  double chance = 1.0;  ///< probability that noise without a line exceeds its neighbourhood this much
};

/// The most significant line of all j/q with 2 <= q <= 12 where q does not divide n; nothing if there is none to test.
///
/// The real and imaginary parts of the Fourier sum of (x, y) at the frequency of the line form a matrix H of sums of
/// squares and products with 2 degrees of freedom (1 at frequency 1/2). Those at the M nearest frequencies form a
/// matrix E with 2M. If the noise is approximately normal and its spectrum is smooth over these frequencies, L =
/// sqrt(det E/det(E + H)) has the law Beta(2M - 1, 2) (Wilks 1932; Anderson, Multivariate Analysis, 8.4):
///
///     P(L <= y) = y^(2M-1) (2M - (2M - 1) y),   at frequency 1/2: y^(2M-1)
///
/// Each line is compared with its own neighbourhood. It is therefore distinguished from the broad maximum of noise with
/// long memory. `deviations` are measured from the centres of the classes k mod n.
///
/// The chance of every line is bounded first (line_bounds.hpp); it is computed only for lines that may have the least.
/// If bounds show that only one line may have it, and that it is below `needed_from`, its upper bound is returned.
[[nodiscard]] std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution,
                                                 double needed_from = 0.0);

/// As strongest_line, with the chance of every line computed: what a test compares with.
[[nodiscard]] std::optional<Line> strongest_line_of_all(std::span<const PlanePoint> deviations, int n,
                                                        double resolution);

}  // namespace rocking::section
