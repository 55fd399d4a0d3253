#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "rocking/section/classification.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Cosine and sine of four angles.
struct FourTurns {
  Four cosine;
  Four sine;

  [[nodiscard]] FourTurns followed_by(const FourTurns& b) const {
    return {roughly_fused(cosine, b.cosine, -sine * b.sine), roughly_fused(sine, b.cosine, cosine * b.sine)};
  }
};

/// Fourier sums of x and y at four frequencies.
struct FourSums {
  Four real_x;
  Four imaginary_x;
  Four real_y;
  Four imaginary_y;
};

/// Real and imaginary parts of the Fourier sum of the points at a frequency.
struct Amplitude {
  PlanePoint real;
  PlanePoint imaginary;

  void add_to(Covariance& sum) const {
    sum.add(real);
    sum.add(imaginary);
  }
};

/// Fourier sums of a series of L points at the frequencies j/Q + s/L and j/Q - s/L, where Q divides L, each multiplied
/// by a number of modulus 1 that is not specified.
///
/// The points k = Q a + b are summed first over a, which needs only s, then over b, which needs j and s. The first sums
/// serve all j: about L + Q J products for J frequencies j/Q, where single sums take L J. Angles are counted from the
/// middle of the rows a and of the columns b. What is equally far from the middle has the same cosine and the opposite
/// sine, which halves the products.
class NearbySums {
 public:
  static constexpr std::size_t most_vectors = 4;  ///< of four steps each: s = 0 ... 15

  /// Begins with a series; Q is `modulus` <= 12.
  void begin(std::span<const PlanePoint> points, std::size_t modulus);

  struct Sides {
    FourSums above;  ///< at j/Q + s/L
    FourSums below;  ///< at j/Q - s/L
  };

  /// The sums for s = 4 v ... 4 v + 3; j < Q, v < `most_vectors`.
  [[nodiscard]] Sides at(std::size_t j, std::size_t v);

  /// Real and imaginary parts of a sum at j/Q, multiplied by 1 instead of that number.
  [[nodiscard]] Amplitude amplitude(std::size_t j, const FourSums& above) const;

 private:
  static constexpr std::size_t most_columns = (static_cast<std::size_t>(longest_period) + 1) / 2;

  /// First sums of columns equally far from the middle: the sum and the difference of the two.
  struct Columns {
    std::array<FourSums, most_columns> even;
    std::array<FourSums, most_columns> odd;
  };

  using ColumnSums = std::array<FourSums, static_cast<std::size_t>(longest_period)>;  // by b

  [[nodiscard]] ColumnSums sum_over_rows(std::size_t v) const;
  void add_columns(std::size_t v);

  std::size_t modulus_ = 0;
  std::size_t length_ = 0;
  std::vector<double> rows_;  ///< of rows equally far from the middle: sum and difference of the coordinates
  std::array<Columns, most_vectors> columns_;  ///< as far as they were needed
  std::size_t vectors_ = 0;                    ///< number of these
};

}  // namespace rocking::section
