#pragma once

#include <limits>

#include "rocking/base/lane.hpp"

namespace rocking::integrate {

/// Root of y > 0 of the given degree to a few per cent, from the bits of y: a double's bits, read as an integer, are its
/// logarithm, linear between powers of two. The error of log2(y) is at most 0.0861 and is divided by the degree; that of
/// the way back is at most 0.0861, or 6 %. The upper half of the bits is enough, and is exact as a double, so that all is
/// IEEE arithmetic and the bits are the same everywhere.
template <base::Lane Real>
[[nodiscard]] Real rough_root(Real y, int degree) {
  using base::from_upper_word, base::fused, base::upper_word;
  constexpr double one = 0x3ff00000;
  return from_upper_word(fused(upper_word(y) - Real(one), Real(1.0 / degree), Real(one)));
}

/// Length h at which the larger of two successive last terms, last_but_one h^(order - 1) and last h^order, has grown to
/// `largest`. Two terms, since every second coefficient may vanish (a sine about its zero). Infinite if both do.
template <base::Lane Real>
[[nodiscard]] Real step_length(Real last_but_one, Real last, int order, Real largest) {
  using base::select, base::smaller;
  const auto reach = [largest](Real term, int degree) {
    const Real ratio = largest / select(term < Real(0.0), -term, term);
    return select(ratio < Real(0x1p1000), rough_root(ratio, degree), Real(std::numeric_limits<double>::infinity()));
  };
  return smaller(reach(last_but_one, order - 1), reach(last, order));
}

}  // namespace rocking::integrate
