#include "rocking/base/normal_law.hpp"

#include <cmath>

#include "rocking/base/elementary.hpp"

namespace rocking::base {
namespace {

constexpr double largest_argument = 37.0;  // the density of a larger one is subnormal

/// Phi(x) - 1/2: all terms have the sign of x.
double probability_from_zero(double x) {
  double term = x;
  double sum = x;
  for (double odd = 3.0; std::abs(term) > 1e-17 * std::abs(sum); odd += 2.0) {
    term *= x * x / odd;
    sum += term;
  }
  return normal_density(x) * sum;
}

/// Upper tail over density, for x >= 1.5.
double mills_ratio(double x) {
  constexpr int levels = 150;
  double fraction = x;
  for (int k = levels; k >= 1; --k) fraction = x + k / fraction;
  return 1.0 / fraction;
}

/// Of a tail up to 1/2.
double quantile_of_small_tail(double tail) {
  const double t = std::sqrt(-2.0 * natural_logarithm(tail));
  double x = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
  for (int step = 0; step < 2; ++step) {
    const double newton = (normal_upper_tail(x) - tail) / normal_density(x);
    x += newton / (1.0 - 0.5 * x * newton);
  }
  return x;
}

}  // namespace

double normal_density(double x) {
  constexpr double one_over_root_two_pi = 0x1.9884533d43651p-2;
  if (std::abs(x) > largest_argument) return 0.0;
  const double square = x * x;
  const double rounding = std::fma(x, x, -square);  // its effect is square times larger than a rounding of the result
  return one_over_root_two_pi * exponential(-0.5 * square) * (1.0 - 0.5 * rounding);
}

double normal_upper_tail(double x) {
  if (x > largest_argument) return 0.0;
  if (x < 0.0) return 1.0 - normal_upper_tail(-x);
  return x < 1.5 ? 0.5 - probability_from_zero(x) : normal_density(x) * mills_ratio(x);
}

double normal_quantile_of_tail(double tail) {
  return tail <= 0.5 ? quantile_of_small_tail(tail) : -quantile_of_small_tail(1.0 - tail);
}

}  // namespace rocking::base
