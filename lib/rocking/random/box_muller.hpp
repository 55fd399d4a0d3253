#pragma once

#include <cstdint>

#include "rocking/random/philox.hpp"

namespace rocking::random {

/// Two independent draws from N(0, 1), computed from one block.
struct NormalPair {
  double cosine;  ///< member 0
  double sine;    ///< member 1

  /// The draw with this index: even indices use `cosine`, odd ones `sine`.
  [[nodiscard]] constexpr double operator[](std::uint64_t index) const { return index % 2 == 0 ? cosine : sine; }
};

/// Largest absolute value of a draw, sqrt(-2 ln 2^-53). The probability of a larger value under a normal law is
/// 1.02e-17.
inline constexpr double normal_tail_limit = 0x1.124b2800eda48p+3;

/// Box-Muller transformation of a block of random words.
///
///     z_0 = sqrt(-2 ln u_1) cos(2 pi u_2),   z_1 = sqrt(-2 ln u_1) sin(2 pi u_2)
///
/// u_1 in (0, 1] is computed from half 0 of the block, u_2 in [0, 1) from half 1, with 53 bits each. The angle is
/// reduced to an eighth of a turn in integer arithmetic, without error. The bits are the same on every machine. Source:
/// Box & Muller (1958), Ann. Math. Stat. 29(2) 610-611; Jeong & Yang (2012) Eq. 31, 32.
[[nodiscard]] NormalPair box_muller(const Words& block);

}  // namespace rocking::random
