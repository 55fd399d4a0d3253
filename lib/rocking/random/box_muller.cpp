#include "rocking/random/box_muller.hpp"

#include <cmath>

#include "rocking/base/elementary.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

/// cos and sin of 2 pi k 2^-53, k the upper 53 bits.
base::SinCos<double> sin_cos_of_turn(std::uint64_t bits) {
  constexpr double half_pi = 0x1.921fb54442d18p+0;
  constexpr unsigned quarter_bits = 51;
  const std::uint64_t k = bits >> 11U;
  const std::uint64_t quadrant = (k + (std::uint64_t{1} << (quarter_bits - 1))) >> quarter_bits;  // nearest, 0 ... 4
  const auto rest = static_cast<std::int64_t>(k) - static_cast<std::int64_t>(quadrant << quarter_bits);
  const auto [sine, cosine] = base::reduced_sin_cos(static_cast<double>(rest) * 0x1p-51 * half_pi);
  // A quarter turn swaps the two, half a turn changes a sign. Products, since a branch here goes wrong half the time.
  const auto sign = [](std::uint64_t quarters) { return 1.0 - static_cast<double>(quarters & 2U); };
  const bool swapped = quadrant % 2 == 1;
  return {sign(quadrant) * base::select(swapped, cosine, sine),
          sign(quadrant + 1) * base::select(swapped, sine, cosine)};
}

}  // namespace

NormalPair box_muller(const Words& block) {
  const double radius = std::sqrt(-2.0 * base::natural_logarithm(uniform_to_one(half_of(block, 0))));
  const auto [sine, cosine] = sin_cos_of_turn(half_of(block, 1));
  return {radius * cosine, radius * sine};
}

}  // namespace rocking::random
