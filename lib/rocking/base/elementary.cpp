#include "rocking/base/elementary.hpp"

namespace rocking::base {

double arc_tangent(double x) {
  // Angle of the direction (run, rise) [rad]. One of the two is 1, and rise <= run. The angle is halved twice, a series
  // gives its arc tangent, and one Newton step corrects it. The residual of that step, rise cos - run sin, uses x
  // without rounding.
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
