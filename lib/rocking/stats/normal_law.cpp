#include "rocking/stats/normal_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace rocking::stats {
namespace {

/// x times the density, 0 at infinity.
double moment_density(double x) { return std::isfinite(x) ? x * normal_density(x) : 0.0; }

constexpr double table_begin = -16.0;
constexpr double table_end = 9.0;
constexpr double per_unit = 32.0;
constexpr auto intervals = static_cast<std::size_t>((table_end - table_begin) * per_unit);

LogNormalProbability computed(double z) {
  const double value = log_normal_cdf(z);
  return {.value = value, .slope = std::exp(-0.5 * z * z - value) / std::sqrt(2.0 * std::numbers::pi)};
}

LogNormalProbability far_above(double z) {
  const double y = 1.0 / (z * z);
  return {.value = -normal_density(z) * (1.0 - y * (1.0 - 3.0 * y)) / z, .slope = normal_density(z)};
}

/// A function and its first two derivatives.
struct Derivatives {
  double value, first, second;
};

/// ln Phi and its slope at z, differentiated by z/h.
std::array<Derivatives, 2> node(double z) {
  const auto [value, slope] = computed(z);
  const double bend = -slope * (z + slope);
  const double third = -bend * (z + slope) - slope * (1.0 + bend);
  constexpr double h = 1.0 / per_unit;
  return {{{value, slope * h, bend * h * h}, {slope, bend * h, third * h * h}}};
}

/// Coefficients of a polynomial in the place from 0 to 1 within an interval.
using Quintic = std::array<double, 6>;

Quintic between(const Derivatives& begin, const Derivatives& end) {
  // What the parabola at the begin leaves at the end, of the value and two derivatives.
  const double value = end.value - begin.value - begin.first - 0.5 * begin.second;
  const double slope = end.first - begin.first - begin.second;
  const double bend = end.second - begin.second;
  return {begin.value,
          begin.first,
          0.5 * begin.second,
          10.0 * value - 4.0 * slope + 0.5 * bend,
          -15.0 * value + 7.0 * slope - bend,
          6.0 * value - 3.0 * slope + 0.5 * bend};
}

/// The coefficients of both functions in one interval, side by side, so that both are evaluated at once.
using Interpolation = std::array<std::array<double, 2>, 6>;

LogNormalProbability at(const Interpolation& both, double t) {
  std::array<double, 2> sum = both[5];
  for (std::size_t k = 5; k-- > 0;) {
    for (std::size_t i = 0; i < 2; ++i) sum[i] = both[k][i] + t * sum[i];
  }
  return {.value = sum[0], .slope = sum[1]};
}

std::array<Interpolation, intervals> interpolations() {
  std::array<Interpolation, intervals> table{};
  for (std::size_t i = 0; i < intervals; ++i) {
    const auto begin = node(table_begin + static_cast<double>(i) / per_unit);
    const auto end = node(table_begin + static_cast<double>(i + 1) / per_unit);
    for (std::size_t function = 0; function < 2; ++function) {
      const Quintic quintic = between(begin[function], end[function]);
      for (std::size_t k = 0; k < quintic.size(); ++k) table[i][k][function] = quintic[k];
    }
  }
  return table;
}

}  // namespace

double two_sided_t_quantile(double confidence, double degrees_of_freedom) {
  const double tail = 0.5 * (1.0 - confidence);
  if (std::isinf(degrees_of_freedom)) return quantile(complement(boost::math::normal_distribution<double>(), tail));
  return quantile(complement(boost::math::students_t_distribution<double>(degrees_of_freedom), tail));
}

double normal_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

double normal_cdf(double z) { return 0.5 * boost::math::erfc(-z / std::numbers::sqrt2); }

double two_sided_normal_p_value(double z) { return 2.0 * normal_cdf(-std::abs(z)); }

double log_normal_cdf(double z) {
  if (z > 0.0) return std::log1p(-normal_cdf(-z));
  if (z > -30.0) return std::log(normal_cdf(z));
  // Laplace's series; at z = -30 the first omitted term, 105/z^8, is 2e-10 of a value of 454.
  const double y = 1.0 / (z * z);
  const double series = -y * (1.0 - y * (3.0 - 15.0 * y));
  return -0.5 * z * z - std::log(-z * std::sqrt(2.0 * std::numbers::pi)) + std::log1p(series);
}

MeanAndSigma clamped_normal(const MeanAndSigma& law, double low, double high) {
  // In standard units about the mean: E[u] and E[u^2] of u = min(max(z, a), b).
  const double a = (low - law.mean) / law.sigma;
  const double b = (high - law.mean) / law.sigma;
  const double below = normal_cdf(a), above = normal_cdf(-b);
  const auto part = [](double weight, double value) { return weight > 0.0 ? weight * value : 0.0; };
  const double mean = part(below, a) + part(above, b) + normal_density(a) - normal_density(b);
  const double square =
      part(below, a * a) + part(above, b * b) + (1.0 - below - above) + moment_density(a) - moment_density(b);
  return {law.mean + law.sigma * mean, law.sigma * std::sqrt(std::max(0.0, square - mean * mean))};
}

MeanAndSigma smaller_of_normals(const MeanAndSigma& first, const MeanAndSigma& second, double correlation) {
  const double spread = std::sqrt(std::max(
      0.0, first.sigma * first.sigma + second.sigma * second.sigma - 2.0 * correlation * first.sigma * second.sigma));
  if (!(spread > 0.0)) return first.mean <= second.mean ? first : second;
  const double ahead = (second.mean - first.mean) / spread;
  const double is_first = normal_cdf(ahead), is_second = normal_cdf(-ahead);
  const double mean = first.mean * is_first + second.mean * is_second - spread * normal_density(ahead);
  const double square = (first.mean * first.mean + first.sigma * first.sigma) * is_first +
                        (second.mean * second.mean + second.sigma * second.sigma) * is_second -
                        (first.mean + second.mean) * spread * normal_density(ahead);
  return {mean, std::sqrt(std::max(0.0, square - mean * mean))};
}

LogNormalProbability log_normal_probability(double z) {
  LogNormalProbability found;
  log_normal_probabilities({&z, 1}, {&found, 1});
  return found;
}

void log_normal_probabilities(std::span<const double> z, std::span<LogNormalProbability> found) {
  static const std::array<Interpolation, intervals> table = interpolations();
  bool is_any_outside = false;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const bool is_inside = table_begin <= z[i] && z[i] < table_end;  // not if z is not a number
    is_any_outside |= !is_inside;
    const double place = ((is_inside ? z[i] : table_begin) - table_begin) * per_unit;
    const auto number = std::min(static_cast<int>(intervals) - 1, static_cast<int>(place));  // may round up to the end
    found[i] = at(table[static_cast<std::size_t>(number)], place - number);
  }
  if (!is_any_outside) return;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (z[i] >= table_end) {
      found[i] = far_above(z[i]);
    } else if (!(z[i] >= table_begin)) {
      found[i] = computed(z[i]);
    }
  }
}

double mills_ratio(double z) {
  if (z <= -table_begin) return 1.0 / log_normal_probability(-z).slope;
  if (z < 25.0) return normal_cdf(-z) / normal_density(z);
  // Laplace's series: the first omitted term, 10395/z^12, is 2e-13 at z = 25.
  const double y = 1.0 / (z * z);
  return (1.0 - y * (1.0 - y * (3.0 - y * (15.0 - y * (105.0 - y * 945.0))))) / z;
}

}  // namespace rocking::stats
