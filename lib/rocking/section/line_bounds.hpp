#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "rocking/section/chance_of_sums.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/line_neighbourhood.hpp"
#include "rocking/section/nearby_sums.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Bounds of line_chance of all tested lines, in the order of tested_lines. Lines whose denominator divides n are not
/// tested; their bounds, and those of fewer than 48 points, are infinite.
using AllChanceBounds = std::array<ChanceBounds, line_count>;

/// Computes the bounds from the same Fourier sums, computed for all lines together (nearby_sums.hpp) in about a tenth of
/// the operations.
///
/// Removing the centres of n classes changes a Fourier sum of L points only at multiples of 1/n, which are not looked
/// at, if n divides L. Therefore the sums of most lines are computed once for all n.
class LineSearch {
 public:
  /// `deviations` from the centres of n classes; of one class, from any point that is not far from them. They must
  /// remain while the object is used.
  LineSearch(std::span<const PlanePoint> deviations, int n, double resolution);

  /// From now on, deviations of the same points from the medians of n classes; n is a multiple of the one before.
  void remove_classes(std::span<const PlanePoint> deviations, int n);

  [[nodiscard]] AllChanceBounds bounds();

 private:
  static constexpr std::size_t longest = static_cast<std::size_t>(longest_period);

  /// Sums of squares and products of Fourier sums at four frequencies.
  struct Powers {
    Four xx;
    Four xy;
    Four yy;
  };
  struct Sides {
    Powers above;
    Powers below;
  };
  struct KnownLine {
    std::array<Sides, NearbySums::most_vectors> sides;
    Amplitude own;
    std::size_t vectors = 0;  ///< number of known sides
  };
  /// Sums for lines for which the series has the same length, and denominators with the same multiple.
  struct Group {
    NearbySums sums;
    int n = 0;         ///< of the deviations of which they are; 0: none
    PlanePoint error;  ///< bounds of the errors of the sums
  };
  [[nodiscard]] AllChanceBounds bounds_of_known_sums();
  [[nodiscard]] std::optional<LineSums> sums_of(std::size_t i);
  [[nodiscard]] Group& group_for(std::size_t modulus);
  [[nodiscard]] const KnownLine& known_line(std::size_t i, std::size_t vectors);
  void forget_group(std::size_t modulus);
  [[nodiscard]] bool forget_older_groups();

  std::span<const PlanePoint> deviations_;
  PlanePoint size_;  ///< sums of the absolute values of the deviations
  int n_;
  double resolution_;
  std::array<Group, longest + 1> groups_;  ///< by modulus
  std::array<KnownLine, line_count> lines_;
};

/// The bounds for deviations that are tested with one n.
[[nodiscard]] inline AllChanceBounds chance_bounds(std::span<const PlanePoint> deviations, int n, double resolution) {
  return LineSearch(deviations, n, resolution).bounds();
}

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
