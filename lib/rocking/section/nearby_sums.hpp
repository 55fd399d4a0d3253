#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "rocking/section/classification.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Cosine and sine of four angles.
struct FourTurns {
  Four cosine;
  Four sine;

  [[nodiscard]] FourTurns followed_by(const FourTurns& b) const {
    return {cosine * b.cosine - sine * b.sine, sine * b.cosine + cosine * b.sine};
  }
};

/// Turns by s/length of a full turn, s = 0, 1, 2 ..., four at a time, as powers of the turn by 1/length.
class PowersOfTurn {
 public:
  explicit PowersOfTurn(std::size_t length);

  /// The next four.
  [[nodiscard]] FourTurns next();

 private:
  FourTurns now_;
  FourTurns by_four_;
};

/// Fourier sums of x and y at four frequencies.
struct FourSums {
  Four real_x;
  Four imaginary_x;
  Four real_y;
  Four imaginary_y;
};

/// Fourier sums of a series of L points at the frequencies j/Q + s/L and j/Q - s/L, where Q divides L.
///
/// The points k = Q a + b are summed first over a, which needs only s, then over b, which needs j and s. The first sums
/// serve all j: about L + Q J products for J frequencies j/Q, where single sums take L J.
class NearbySums {
 public:
  static constexpr std::size_t most_vectors = 4;  ///< of four steps each: s = 0 ... 15

  /// Q is `modulus` <= 12.
  NearbySums(std::span<const PlanePoint> points, std::size_t modulus);

  struct Sides {
    FourSums above;  ///< at j/Q + s/L
    FourSums below;  ///< at j/Q - s/L
  };

  /// The sums for s = 4 v ... 4 v + 3; j < Q, v < `most_vectors`.
  [[nodiscard]] Sides at(std::size_t j, std::size_t v);

 private:
  using FirstSums = std::array<FourSums, static_cast<std::size_t>(longest_period)>;  // by b

  void sum_over_rows(const FourTurns& row_turn, const FourTurns& point_turn, FirstSums& sums) const;

  std::span<const PlanePoint> points_;
  std::size_t modulus_;
  std::array<double, static_cast<std::size_t>(longest_period)> cosines_{};  ///< of 2 pi b/Q
  std::array<double, static_cast<std::size_t>(longest_period)> sines_{};
  PowersOfTurn row_turns_;
  PowersOfTurn point_turns_;
  std::array<FirstSums, most_vectors> first_sums_;  ///< as far as they were needed
  std::size_t vectors_ = 0;                         ///< number of first sums
};

}  // namespace rocking::section
