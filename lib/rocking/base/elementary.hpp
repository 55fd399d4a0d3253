#pragma once

#include <array>

#include "rocking/base/lane.hpp"
#include "rocking/base/natural_logarithm.hpp"

/// Elementary functions with the same bits on every machine.
///
/// The C library's sin, cos and log differ between machines in their last bits, and a rocking motion magnifies such
/// differences. The functions here use only IEEE operations and explicit fused operations. Their bits therefore do not
/// depend on compiler, processor or C library.
namespace rocking::base {

template <class Real>
struct SinCos {
  Real sine;
  Real cosine;
};

namespace elementary {

/// 1/k! rounded to double: the Taylor coefficients of sine and cosine. At pi/4 the first omitted terms are 8e-20 (sine,
/// x^19) and 3e-18 (cosine, x^18), below the rounding of the result.
inline constexpr std::array<double, 18> inverse_factorial = [] {
  std::array<double, 18> table{1.0};
  double factorial = 1.0;  // exact up to 18! < 2^53
  for (std::size_t k = 1; k < table.size(); ++k) {
    factorial *= static_cast<double>(k);
    table[k] = 1.0 / factorial;
  }
  return table;
}();

}  // namespace elementary

/// sin(x) and cos(x) on the reduced range abs(x) <= pi/4 [rad]. A slightly larger abs(x) is accepted.
template <Number Real>
[[nodiscard]] inline SinCos<Real> reduced_sin_cos(Real x) {
  const auto& f = elementary::inverse_factorial;
  const Real y = x * x;
  Real sine(f[17]);
  for (int k = 15; k >= 3; k -= 2) sine = fused(sine, -y, Real(f[static_cast<std::size_t>(k)]));
  sine = fused(sine * -y, x, x);
  Real cosine(f[16]);
  for (int k = 14; k >= 2; k -= 2) cosine = fused(cosine, -y, Real(f[static_cast<std::size_t>(k)]));
  // The rounding of 1 - y/2 loses the bits of y below 2^-53; they are added back.
  const Real tail = cosine - Real(0.5);
  const Real half = Real(0.5) * y;
  const Real head = Real(1.0) - half;
  cosine = head + (((Real(1.0) - head) - half) - tail * y);
  return {sine, cosine};
}

/// sin(x) and cos(x) for abs(x) <= 1e6 [rad]; error below 1.5 ulp of each result.
///
/// Argument reduction by Cody and Waite: x - q pi/2 with pi/2 in three parts and fused products. The reduced argument
/// keeps its digits also next to a multiple of pi/2. There is no branch, so all lanes follow the same path.
template <Lane Real>
[[nodiscard]] inline SinCos<Real> sin_cos(Real x) {
  constexpr double half_pi_1 = 0x1.921fb54442d18p+0;
  constexpr double half_pi_2 = 0x1.1a62633145c07p-54;
  constexpr double half_pi_3 = -0x1.f1976b7ed8fbcp-110;
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  constexpr double rounder = 0x1.8p52;  // adding and subtracting it rounds to the nearest integer

  const Real q = fused(x, Real(two_over_pi), Real(rounder)) - Real(rounder);
  Real r = fused(q, Real(-half_pi_1), x);
  r = fused(q, Real(-half_pi_2), r);
  r = fused(q, Real(-half_pi_3), r);
  const SinCos<Real> reduced = reduced_sin_cos(r);

  // The quadrant, q modulo 4, in -2 ... 2.
  const Real quarter = Real(0.25) * q;
  const Real quadrant = q - Real(4.0) * ((quarter + Real(rounder)) - Real(rounder));
  const auto square = quadrant * quadrant;
  const auto swapped = (Real(0.5) < square) && (square < Real(2.0));  // quadrant is 1 or -1
  const auto opposite = Real(2.0) < square;                           // quadrant is 2 or -2
  const Real sine = select(swapped, reduced.cosine, reduced.sine);
  const Real cosine = select(swapped, reduced.sine, reduced.cosine);
  const auto flip_sine = opposite || (swapped && quadrant < Real(0.0));
  const auto flip_cosine = opposite || (swapped && Real(0.0) < quadrant);
  return {select(flip_sine, -sine, sine), select(flip_cosine, -cosine, cosine)};
}

/// e^x for -708 <= x <= 709, error below 1 ulp.
///
/// e^x = 2^k e^r with k = x/ln 2 rounded to an integer and r = x - k ln 2, abs(r) <= 0.3466; ln 2 in two parts, the
/// products fused. The first term left out of the series of e^r is r^14/14! <= 5e-18.
template <Lane Real>
[[nodiscard]] inline Real exponential(Real x) {
  constexpr double ln2_high = 0x1.62e42fefa39efp-1;
  constexpr double ln2_low = 0x1.abc9e3b39803fp-56;
  constexpr double one_over_ln2 = 0x1.71547652b82fep+0;
  constexpr double rounder = 0x1.8p52;  // adding and taking away rounds to the nearest integer
  const auto& f = elementary::inverse_factorial;
  const Real k = fused(x, Real(one_over_ln2), Real(rounder)) - Real(rounder);
  Real r = fused(k, Real(-ln2_high), x);
  r = fused(k, Real(-ln2_low), r);
  Real rest(f[13]);
  for (int i = 12; i >= 2; --i) rest = fused(rest, r, Real(f[static_cast<std::size_t>(i)]));
  const Real power = from_upper_word((k + Real(1023.0)) * Real(0x1p20));  // 2^k: the exponent begins at bit 20
  return power * (Real(1.0) + fused(rest * r, r, r));
}

/// For abs(x) below this value sin_cos returns the bits of reduced_sin_cos, at a higher cost.
inline constexpr double almost_quarter_pi = 0.785;

/// atan(x) for finite x, error below 2 ulp.
[[nodiscard]] double arc_tangent(double x);

}  // namespace rocking::base
