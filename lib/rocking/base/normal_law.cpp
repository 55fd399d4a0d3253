#include "rocking/base/normal_law.hpp"

#include <algorithm>
#include <array>
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

/// Of a rule for the integral from 0 to 1.
struct Node {
  double at;
  double weight;
};

constexpr std::size_t rule_nodes = 64;

/// Gauss and Legendre's rule: the roots of the polynomial by Newton's method (Abramowitz & Stegun 1964, 25.4.29).
std::array<Node, rule_nodes> legendre_rule() {
  constexpr double pi = 0x1.921fb54442d18p+1;
  std::array<Node, rule_nodes> rule{};
  for (std::size_t i = 0; i < rule_nodes; ++i) {
    double x = sin_cos(pi * (static_cast<double>(i) + 0.75) / (rule_nodes + 0.5)).cosine;
    double slope = 1.0;
    for (int step = 0; step < 6; ++step) {
      double before = 1.0;
      double value = x;
      for (std::size_t n = 2; n <= rule_nodes; ++n) {
        const auto order = static_cast<double>(n);
        const double next = ((2.0 * order - 1.0) * x * value - (order - 1.0) * before) / order;
        before = value;
        value = next;
      }
      slope = rule_nodes * (before - x * value) / (1.0 - x * x);
      x -= value / slope;
    }
    rule[i] = {0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return rule;
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

double normal_mean_above(double low, double width) {
  static const std::array<Node, rule_nodes> rule = legendre_rule();
  // The density over the largest one is exp(-(z^2 - peak^2)/2). In a tail it falls by 40 over one length of the rule, within
  // the bulk the length is at most 18: the error of the rule, which Bernstein ellipses bound, is below 1e-25.
  constexpr double logarithm = 40.0;
  const double a = std::min(low, 1e100);
  const double bulk = std::sqrt(2.0 * logarithm);
  const double start = a < -bulk ? -a - bulk : 0.0;
  const double reach = a > 0.0 ? 2.0 * logarithm / (a + std::sqrt(a * a + 2.0 * logarithm)) : bulk - a;
  const double length = std::min(width, reach) - start;
  const double peak = std::max(0.0, -a);  // where the density is largest
  double sum = 0.0;
  double moment = 0.0;
  for (const Node& node : rule) {
    const double y = start + length * node.at;
    const double share = node.weight * exponential(-(y - peak) * (std::max(0.0, a) + 0.5 * (y - peak)));
    sum += share;
    moment += share * y;
  }
  return moment / sum;
}

}  // namespace rocking::base
