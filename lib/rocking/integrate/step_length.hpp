#pragma once

#include "rocking/base/lane.hpp"

namespace rocking::integrate {

/// Root of abs(a/b), a != 0, of the given degree to a few per cent, from the bits of a and b: a double's bits, read as
/// an integer, are its logarithm, linear between powers of two. The error of log2(a/b) is at most 0.0861 and is divided
/// by the degree; that of the way back is at most 0.0861, or 6 %. The upper half of the bits suffices and is exact as a
/// double, so that only IEEE arithmetic without a division is needed and the bits are the same on every machine. For b
/// = 0 it is large: above 2^60 for a > 1e-18, a degree of at most 16.
template <base::Lane Real>
[[nodiscard]] Real rough_root(Real a, Real b, int degree) {
  using base::from_upper_word, base::fused, base::upper_word;
  constexpr double one = 0x3ff00000;
  return from_upper_word(fused(upper_word(a) - upper_word(b), Real(1.0 / degree), Real(one)));
}

/// Length h at which the larger of two successive last terms, last_but_one h^(order - 1) and last h^order, has grown to
/// `largest`. Two terms, because every second coefficient may vanish (a sine about its zero).
template <base::Lane Real>
[[nodiscard]] Real step_length(Real last_but_one, Real last, int order, Real largest) {
  using base::smaller;
  return smaller(rough_root(largest, last_but_one, order - 1), rough_root(largest, last, order));
}

}  // namespace rocking::integrate
