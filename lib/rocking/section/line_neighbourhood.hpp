#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace rocking::section {

/// A reduced fraction of the excitation frequency, in (0, 1/2], at which deviations may have a spectral line.
struct LineFrequency {
  int numerator = 0;
  int denominator = 1;
};

/// Number of reduced fractions j/q in (0, 1/2] with q <= 12: the tested lines.
inline constexpr int line_count = 23;

/// The tested lines, by denominator and numerator.
[[nodiscard]] std::span<const LineFrequency, line_count> tested_lines();

inline constexpr std::size_t most_neighbours = 13;  ///< twelve, and one more on the other side of the last step

/// The frequencies with which a spectral line is compared: M nearest ones on both sides, inside (0, 1/2), without those
/// that the class means remove.
struct Neighbourhood {
  std::array<double, most_neighbours> frequencies{};  ///< per period
  std::array<int, most_neighbours> steps{};           ///< from the line, in frequency bins
  std::size_t count = 0;                              ///< M
};

/// The neighbourhood of a line in a series of `points` points from which the means of n classes were removed.
[[nodiscard]] Neighbourhood neighbourhood_of(double frequency, int n, std::size_t points);

/// What the resolution of the points adds to the sums of squares of the Fourier sums of M neighbours.
[[nodiscard]] inline double squares_of_resolution(double resolution, std::size_t points, std::size_t neighbours) {
  return resolution * resolution * static_cast<double>(points) * static_cast<double>(neighbours);
}

/// P(L <= ratio) of line_bounds.hpp for a line compared with M neighbours.
[[nodiscard]] double chance_of_ratio(double ratio, std::size_t neighbours, bool at_half);

}  // namespace rocking::section
