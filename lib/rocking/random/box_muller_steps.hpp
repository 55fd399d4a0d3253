#pragma once

#include <cmath>
#include <cstdint>

#include "rocking/base/elementary.hpp"
#include "rocking/random/uniform.hpp"

/// The two steps of the Box-Muller transformation. They are shared by the code for one block and the code for many
/// blocks, so that both give the same bits. Inlined into a loop they contain no branch, no call and no conversion that
/// a vector unit lacks. `Bits` holds one half of a block, or one half of each of several blocks.
namespace rocking::random {

/// sqrt(-2 ln u_1), with u_1 computed from `bits`.
template <class Bits>
[[gnu::always_inline]] inline auto radius_of(Bits bits) {
  using std::sqrt;
  using Real = decltype(uniform_to_one(bits));
  return sqrt(Real(-2.0) * base::natural_logarithm(uniform_to_one(bits)));
}

/// cos and sin of 2 pi k 2^-53, where k is the upper 53 bits.
template <class Bits>
[[gnu::always_inline]] inline auto sin_cos_of_turn(Bits bits) {
  using base::bits_of;
  using base::number_of;
  using Real = decltype(number_of(bits));
  constexpr double half_pi = 0x1.921fb54442d18p+0;
  constexpr unsigned quarter_bits = 51;
  const Bits k = bits >> 11U;
  const Bits quadrant = (k + (std::uint64_t{1} << (quarter_bits - 1))) >> quarter_bits;  // nearest, 0 ... 4
  const Bits rest = k - (quadrant << quarter_bits);                                      // -2^50 ... 2^50, modulo 2^64
  const Real signed_rest = number_of(rest + 0x4338000000000000ULL) - Real(0x1.8p52);     // exact
  const auto [sine, cosine] = base::reduced_sin_cos(signed_rest * Real(0x1p-51) * Real(half_pi));
  // A quarter turn exchanges sine and cosine, half a turn changes the sign of both.
  const Bits swap = (bits_of(sine) ^ bits_of(cosine)) & (Bits(0) - (quadrant & 1U));
  const auto sign = [](Bits quarters) { return (quarters & 2U) << 62U; };
  return base::SinCos<Real>{number_of(bits_of(sine) ^ swap ^ sign(quadrant)),
                            number_of(bits_of(cosine) ^ swap ^ sign(quadrant + 1U))};
}

}  // namespace rocking::random
