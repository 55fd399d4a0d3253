#include "rocking/base/elementary.hpp"

#include <bit>
#include <cstdint>

namespace rocking::base {

double natural_logarithm(double x) {
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh(s), s = (m - 1)/(m + 1), abs(s) <= 0.1716.
  constexpr double ln2_high = 0x1.62e42fefa3800p-1;  // 11 trailing zero bits: k ln2_high is exact
  constexpr double ln2_low = 0x1.ef35793c76730p-45;
  constexpr double root_half = 0x1.6a09e667f3bcdp-1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<std::int64_t>(bits >> 52U) - 1022;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3fe0000000000000ULL);
  if (m < root_half) {
    m *= 2.0;
    exponent -= 1;
  }
  const auto k = static_cast<double>(exponent);
  const double f = m - 1.0;  // exact
  const double s = f / (m + 1.0);
  const double y = s * s;
  // artanh(s)/s - 1 = sum y^j/(2j+1); y <= 0.0295, and the first term left out, y^12/25, is 2e-20.
  double tail = 1.0 / 23.0;
  for (int j = 10; j >= 1; --j) tail = std::fma(tail, y, 1.0 / (2 * j + 1));
  // ln m = f - f^2/2 + s (f^2/2 + 2 y tail), whose leading part f is exact (2 s = f - s f).
  const double half_square = 0.5 * f * f;
  const double rest = s * (half_square + 2.0 * y * tail);
  return k * ln2_high + (f - (half_square - (rest + k * ln2_low)));
}

double arc_tangent(double x) {
  // The angle of the direction (run, rise), one of them 1 and rise <= run: two halvings, a series, then one Newton step
  // whose residual rise cos - run sin uses x as it was given.
  const double size = std::abs(x);
  const bool steep = size > 1.0;
  const double rise = steep ? 1.0 : size;
  const double run = steep ? size : 1.0;
  double t = rise / run;
  for (int halving = 0; halving < 2; ++halving) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double square = t * t;  // t <= tan(pi/16) = 0.199; the first term left out is 2e-20
  double sum = 1.0 / 25.0;
  for (int j = 11; j >= 0; --j) sum = std::fma(sum, -square, 1.0 / (2 * j + 1));
  const double guess = 4.0 * t * sum;
  const auto [sine, cosine] = reduced_sin_cos(guess);
  const double correction = std::fma(rise, cosine, -(run * sine)) / std::fma(run, cosine, rise * sine);
  constexpr double half_pi_high = 0x1.921fb54442d18p+0;
  constexpr double half_pi_low = 0x1.1a62633145c07p-54;
  const double angle = steep ? (half_pi_high - guess) - (correction - half_pi_low) : guess + correction;
  return std::copysign(angle, x);
}

}  // namespace rocking::base
