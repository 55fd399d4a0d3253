#include "rocking/stats/normality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/distributions/binomial.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/moments.hpp"

namespace rocking::stats {
namespace {

/// One term of Smirnov's series: (1/pi) integral of exp(-x z/2)/(x sqrt(abs D(x))) from one zero of D to the next.
///
/// D(x) = product over j of (1 - x/(j (j + 1))) = -cos(pi/2 sqrt(1 + 4 x))/(pi x). With x = middle - half cos(t) the
/// integrand is even, periodic and smooth in t. The trapezoidal rule then converges faster than any power; with 64
/// steps its relative error at z = 100 is 1e-9.
double smirnov_term(double z, double low, double high) {
  constexpr int nodes = 64;
  const double middle = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  double sum = 0.0;
  for (int i = 0; i < nodes; ++i) {
    const double t = std::numbers::pi * (i + 0.5) / nodes;
    const double x = middle - half * std::cos(t);
    const double product =
        std::abs(std::cos(0.5 * std::numbers::pi * std::sqrt(1.0 + 4.0 * x))) / (std::numbers::pi * x);
    sum += std::exp(-0.5 * x * z) * half * std::sin(t) / (x * std::sqrt(product));
  }
  return sum / nodes;
}

/// P(A^2 >= z) for n = infinity. For z < 2 by Marsaglia & Marsaglia (2004), constants as printed, absolute error 2e-6.
/// For larger z by Smirnov's series for A^2 = sum Y_j^2/(j (j + 1)), relative error 1e-12: the third term is below
/// exp(-15 z).
double limiting_tail_of_squares(double z) {
  if (z <= 0.0) return 1.0;
  if (z >= 2.0) return smirnov_term(z, 2.0, 6.0) - smirnov_term(z, 12.0, 20.0);
  const double polynomial =
      2.00012 + (0.247105 - (0.0649821 - (0.0347962 - (0.011672 - 0.00168691 * z) * z) * z) * z) * z;
  return 1.0 - std::exp(-1.2337141 / z) / std::sqrt(z) * polynomial;
}

/// Correction for finite n of the limiting probability x of a smaller A^2: Marsaglia & Marsaglia, constants as printed.
double finite_sample_correction(double n, double x) {
  if (x > 0.8) {
    return (-130.2137 + (745.2337 - (1705.091 - (1950.646 - (1116.360 - 255.7844 * x) * x) * x) * x) * x) / n;
  }
  const double crossing = 0.01265 + 0.1757 / n;
  if (x < crossing) {
    const double t = x / crossing;
    return std::sqrt(t) * (1.0 - t) * (49.0 * t - 102.0) * (0.0037 / (n * n) + 0.00078 / n + 0.00006) / n;
  }
  const double t = (x - crossing) / (0.8 - crossing);
  const double polynomial = -0.00022633 + (6.54034 - (14.6538 - (14.458 - (8.259 - 1.91864 * t) * t) * t) * t) * t;
  return polynomial * (0.04213 / n + 0.01365) / n;
}

/// P(sqrt(n) D >= x) for n = infinity, by the one of Kolmogorov's two series that converges quickly. Both stop before a
/// negligible term: 1e-20 where the series change.
double limiting_tail(double x) {
  if (x <= 0.0) return 1.0;
  double sum = 0.0;
  if (x < 0.85) {
    const double exponent = std::numbers::pi * std::numbers::pi / (8.0 * x * x);
    for (const double odd : {1.0, 3.0, 5.0, 7.0}) sum += std::exp(-odd * odd * exponent);
    return 1.0 - std::sqrt(2.0 * std::numbers::pi) / x * sum;
  }
  for (const double k : {1.0, 3.0, 5.0}) {
    sum += std::exp(-2.0 * k * k * x * x) - std::exp(-2.0 * (k + 1.0) * (k + 1.0) * x * x);
  }
  return 2.0 * sum;
}

/// The first count from `low` on for which `holds` is true; `high` if there is none before it. `holds` must be
/// monotone.
template <class Predicate>
std::uint64_t first_where(std::uint64_t low, std::uint64_t high, Predicate holds) {
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

// D'Agostino's transformation is Johnson's S_U curve with the same first four moments.
double skewness_score(double skewness, std::size_t size) {
  ROCKING_EXPECT(size >= 8);
  const auto n = static_cast<double>(size);
  const double y = skewness * std::sqrt((n + 1.0) * (n + 3.0) / (6.0 * (n - 2.0)));
  const double kurtosis =
      3.0 * (n * n + 27.0 * n - 70.0) * (n + 1.0) * (n + 3.0) / ((n - 2.0) * (n + 5.0) * (n + 7.0) * (n + 9.0));
  const double w_squared = std::sqrt(2.0 * (kurtosis - 1.0)) - 1.0;
  const double delta = 1.0 / std::sqrt(0.5 * std::log(w_squared));
  const double alpha = std::sqrt(2.0 / (w_squared - 1.0));
  return delta * std::asinh(y / alpha);
}

// Anscombe & Glynn's transformation is the cube root of a chi-squared number of A degrees.
double kurtosis_score(double kurtosis, std::size_t size) {
  ROCKING_EXPECT(size >= 8);
  const auto n = static_cast<double>(size);
  const double variance = 24.0 * n * (n - 2.0) * (n - 3.0) / ((n + 1.0) * (n + 1.0) * (n + 3.0) * (n + 5.0));
  const double x = (kurtosis - 3.0 * (n - 1.0) / (n + 1.0)) / std::sqrt(variance);
  const double beta = 6.0 * (n * n - 5.0 * n + 2.0) / ((n + 7.0) * (n + 9.0)) *
                      std::sqrt(6.0 * (n + 3.0) * (n + 5.0) / (n * (n - 2.0) * (n - 3.0)));
  const double a = 6.0 + 8.0 / beta * (2.0 / beta + std::sqrt(1.0 + 4.0 / (beta * beta)));
  const double ratio = (1.0 - 2.0 / a) / (1.0 + x * std::sqrt(2.0 / (a - 4.0)));  // < 0 only for extremely small b2
  return (1.0 - 2.0 / (9.0 * a) - std::cbrt(ratio)) / std::sqrt(2.0 / (9.0 * a));
}

TestOfFit dagostino_pearson(std::span<const double> sample) {
  ROCKING_EXPECT(sample.size() >= 8);
  const CentralMoments central = central_moments(sample);
  const double z1 = skewness_score(central.skewness(), sample.size());
  const double z2 = kurtosis_score(central.kurtosis(), sample.size());
  const double statistic = z1 * z1 + z2 * z2;
  return {statistic, std::exp(-0.5 * statistic)};  // chi-squared of 2 degrees of freedom is an exponential law
}

double anderson_darling_p_value(double statistic, std::size_t n) {
  ROCKING_EXPECT(n >= 1);
  const double limit = limiting_tail_of_squares(statistic);
  return std::clamp(limit - finite_sample_correction(static_cast<double>(n), 1.0 - limit), 0.0, 1.0);
}

TestOfFit anderson_darling(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(!sample.empty() && law.sigma > 0.0);
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  CompensatedSum sum;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double from_below = log_normal_cdf(law.score(sorted[i]));
    const double from_above = log_normal_cdf(-law.score(sorted[sorted.size() - 1 - i]));
    sum.add(static_cast<double>(2 * i + 1) * (from_below + from_above));
  }
  const double statistic = -n - sum.value() / n;
  return {statistic, anderson_darling_p_value(statistic, sorted.size())};
}

double kolmogorov_p_value(double distance, std::size_t n) {
  ROCKING_EXPECT(n >= 1);
  const auto size = static_cast<double>(n);
  const double x = std::sqrt(size) * distance;
  return std::clamp(limiting_tail(x + 1.0 / (6.0 * std::sqrt(size)) + (x - 1.0) / (4.0 * size)), 0.0, 1.0);
}

TestOfFit kolmogorov_smirnov(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(!sample.empty() && law.sigma > 0.0);
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double probability = normal_cdf(law.score(sorted[i]));
    const double below = probability - static_cast<double>(i) / n;
    const double above = static_cast<double>(i + 1) / n - probability;
    distance = std::max({distance, below, above});
  }
  return {distance, kolmogorov_p_value(distance, sorted.size())};
}

double two_sided_binomial_p_value(const Proportion& observed, double probability) {
  ROCKING_EXPECT(observed.successes <= observed.trials);
  ROCKING_EXPECT(0.0 <= probability && probability <= 1.0);
  const std::uint64_t n = observed.trials;
  const std::uint64_t k = observed.successes;
  const boost::math::binomial_distribution<double> law(static_cast<double>(n), probability);
  const auto density = [&law](std::uint64_t count) { return pdf(law, static_cast<double>(count)); };
  const auto at_most = [&law](std::uint64_t count) { return cdf(law, static_cast<double>(count)); };
  const auto at_least = [&law](std::uint64_t count) {
    return count == 0 ? 1.0 : cdf(complement(law, static_cast<double>(count - 1)));
  };
  const double bound = density(k) * (1.0 + 1e-7);
  const auto mode = std::min(n, static_cast<std::uint64_t>(std::floor(static_cast<double>(n + 1) * probability)));
  // The density rises up to the mode and falls after it, so that each tail is a range of counts.
  if (density(mode) <= bound) return 1.0;
  if (k < mode) {
    const std::uint64_t upper = first_where(mode, n + 1, [&](std::uint64_t count) { return density(count) <= bound; });
    return std::min(1.0, at_most(k) + (upper <= n ? at_least(upper) : 0.0));
  }
  const std::uint64_t inside = first_where(0, mode, [&](std::uint64_t count) { return density(count) > bound; });
  return std::min(1.0, (inside > 0 ? at_most(inside - 1) : 0.0) + at_least(k));
}

double anderson_darling_p_value_of_own_law(double statistic, std::size_t numbers) {
  const auto n = static_cast<double>(numbers);
  const double a = statistic * (1.0 + 0.75 / n + 2.25 / (n * n));
  if (a < 0.2) return 1.0 - std::exp(-13.436 + 101.14 * a - 223.73 * a * a);
  if (a < 0.34) return 1.0 - std::exp(-8.318 + 42.796 * a - 59.938 * a * a);
  if (a < 0.6) return std::exp(0.9177 - 4.279 * a - 1.38 * a * a);
  const double largest = std::min(a, 10.0);  // the parabola turns up far above
  return std::exp(1.2937 - 5.709 * largest + 0.0186 * largest * largest);
}

double lilliefors_p_value(double distance, std::size_t numbers) {
  const auto n = static_cast<double>(numbers);
  const double d = n > 100.0 ? distance * std::pow(n / 100.0, 0.49) : distance;
  const double m = std::min(n, 100.0);
  const double p = std::exp(-7.01256 * d * d * (m + 2.78019) + 2.99587 * d * std::sqrt(m + 2.78019) - 0.122119 +
                            0.974598 / std::sqrt(m) + 1.67997 / m);
  if (p <= 0.1) return p;
  const double k = (std::sqrt(n) - 0.01 + 0.85 / std::sqrt(n)) * distance;
  const auto quartic = [k](double c0, double c1, double c2, double c3, double c4) {
    return c0 + k * (c1 + k * (c2 + k * (c3 + k * c4)));
  };
  if (k <= 0.302) return 1.0;
  if (k <= 0.5) return quartic(2.76773, -19.828315, 80.709644, -138.55152, 81.218052);
  if (k <= 0.9) return quartic(-4.901232, 40.662806, -97.490286, 94.029866, -32.355711);
  return std::max(0.0, quartic(6.198765, -19.558097, 23.186922, -12.234627, 2.423045));
}

}  // namespace rocking::stats
