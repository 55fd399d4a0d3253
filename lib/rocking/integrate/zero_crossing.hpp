#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "rocking/base/lane.hpp"

namespace rocking::integrate {

/// One step, from the last coefficient on, of a lower bound of sum c[k] x^k on [0, length]: that of c + x q(x) is
/// min(c, 0) + length times that of q.
template <base::Lane Real>
[[nodiscard]] inline Real bound_below(Real bound_of_rest, Real coefficient, Real length) {
  using base::fused, base::smaller;
  return fused(bound_of_rest, length, smaller(coefficient, Real(0.0)));
}

/// Whether p(x) = sum c[k] x^k is shown to stay positive on [0, length] by c[0] and that bound of the rest. False means
/// "not shown".
[[nodiscard]] inline bool is_clearly_positive(std::span<const double> c, double length) {
  double bound = 0.0;
  for (std::size_t k = c.size() - 1; k > 0; --k) bound = bound_below(bound, c[k], length);
  return base::fused(bound, length, c[0]) > 0.0;
}

/// First t in [0, 1] at which p(t) = sum c[k] t^k goes from p >= 0 to p < 0; 0 if it starts below zero, or starts at
/// zero and leaves downwards. Absent if p stays >= 0: a touch without crossing (a double root) is no zero crossing.
///
/// Rigorous up to rounding of the coefficients: Bernstein coefficients enclose the polynomial, so an interval on which
/// all are >= 0 has no crossing and one with a single change of sign has exactly one (Descartes); anything else is
/// halved until one of the two holds or the interval has shrunk to rounding. Therefore no crossing is missed, however
/// short the interval between two of them. Cost: about n^2 additions for n coefficients, and as much for each halving.
/// At most `max_coefficients` coefficients.
/// Source: Lane & Riesenfeld (1981), BIT 21, 112-117 (isolation); Farouki & Rajan (1987), CAGD 4, 191-216 (stability).
[[nodiscard]] std::optional<double> first_zero_crossing(std::span<const double> c);

}  // namespace rocking::integrate
