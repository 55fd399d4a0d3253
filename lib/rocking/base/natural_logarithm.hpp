#pragma once

#include <cstdint>

#include "rocking/base/lane.hpp"

namespace rocking::base {

/// `k` <= 2^53 converted to a floating-point number, exactly.
///
/// Replaces a cast, because AVX2 cannot convert 64-bit integers. The bits of each half of k are placed into the
/// mantissa of a number whose exponent is known.
[[nodiscard]] constexpr double exact_number(std::uint64_t k) {
  const double high =
      number_of(0x4530000000000000ULL | (k >> 32U)) - 0x1.00000001p84;  // 2^52 too small; the sum corrects it
  return high + number_of(0x4330000000000000ULL | (k & 0xffffffffULL));
}

/// ln(x) for normal x > 0, error below 1 ulp.
///
/// Has no branches and no calls, so that a loop over it can be vectorised; each lane gets the same bits as it would get
/// alone. A pack type must provide `bits_of`, `number_of` and `exact_number`.
template <Number Real>
[[nodiscard]] inline Real natural_logarithm(Real x) {
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh(s), s = (m - 1)/(m + 1), abs(s) <= 0.1716.
  constexpr double ln2_high = 0x1.62e42fefa3800p-1;  // 11 trailing zero bits: k ln2_high is exact
  constexpr double ln2_low = 0x1.ef35793c76730p-45;
  constexpr std::uint64_t bits_of_one = 0x3ff0000000000000ULL;
  constexpr std::uint64_t bits_of_root_half = bits_of(0x1.6a09e667f3bcdp-1);
  // After subtracting sqrt(1/2), the exponent field is k + 1023 and the fraction field is that of m.
  const auto shifted = bits_of(x) + (bits_of_one - bits_of_root_half);
  const Real k = exact_number(shifted >> 52U) - Real(1023.0);
  const Real m = number_of((shifted & 0x000fffffffffffffULL) + bits_of_root_half);
  const Real f = m - Real(1.0);  // exact
  const Real s = f / (m + Real(1.0));
  const Real y = s * s;
  // artanh(s)/s - 1 = sum y^j/(2j+1); y <= 0.0295, and the first omitted term, y^12/25, is 2e-20.
  Real tail(1.0 / 23.0);
#pragma GCC unroll 10  // g++ does not vectorise a loop that contains a loop; it unrolls shorter ones without a pragma
  for (int j = 10; j >= 1; --j) tail = fused(tail, y, Real(1.0 / (2 * j + 1)));
  // ln m = f - f^2/2 + s (f^2/2 + 2 y tail). The leading term f is exact (2 s = f - s f).
  const Real half_square = Real(0.5) * f * f;
  const Real rest = s * (half_square + Real(2.0) * y * tail);
  return k * Real(ln2_high) + (f - (half_square - (rest + k * Real(ln2_low))));
}

}  // namespace rocking::base
