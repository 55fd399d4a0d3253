#include "rocking/stats/law_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rocking/stats/moments.hpp"

namespace rocking::stats {
namespace {

/// E[f(x)] under the law: the sum over evenly spaced scores, which converges faster than any power of the step.
template <class F>
double expectation(const LawOfScores& law, const F& f) {
  constexpr double farthest = 9.0;
  constexpr int steps = 3600;
  const double step = 2.0 * farthest / steps;
  const double density_at_mean = 1.0 / std::sqrt(2.0 * std::acos(-1.0));
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double z = -farthest + step * i;
    sum += step * density_at_mean * std::exp(-0.5 * z * z) * f(law.at(z));
  }
  return sum;
}

/// A moment of the sample against that of the law, whose influence function is given for the standardised number.
template <class Influence>
MomentTest tested(double value, double of_law, double unit, std::uint64_t n, const LawOfScores& law,
                  const Influence& influence) {
  const double variance = expectation(law, [&](double x) {
    const double i = influence((x - law.mean) / law.sigma);
    return i * i;
  });
  const double error = unit * std::sqrt(variance / static_cast<double>(n));
  const double z = (value - of_law) / error;
  return {{.value = value, .standard_error = error, .z = z}, two_sided_normal_p_value(z)};
}

ShapeTest shape(const MomentTest& test, double of_law) {
  const auto near = [&](double distance) -> Nearness {
    return {distance, 1.0 - two_sided_normal_p_value(distance / test.moment.standard_error)};
  };
  return {.test = test, .nearness = {near(0.01), near(std::abs(test.moment.value - of_law))}, .of_law = of_law};
}

Histogram histogram_of(std::span<const double> sample, const LawOfScores& law) {
  constexpr std::size_t bins = 40;
  constexpr double reach = 4.0;
  const NormalLaw around{.mean = law.mean, .sigma = law.sigma};
  Histogram histogram = normal_histogram(sample, around, bins, reach);
  const auto n = static_cast<double>(sample.size());
  std::vector<double> below;
  for (const double edge : histogram.edges) below.push_back(n * normal_cdf(law.score(edge)));
  for (std::size_t k = 0; k < bins; ++k) histogram.expected[k] = below[k + 1] - below[k];
  histogram.expected_below = below.front();
  histogram.expected_above = n * normal_cdf(-law.score(histogram.edges.back()));
  return histogram;
}

}  // namespace

std::optional<NormalCheck> check_law(const NormalSamples& samples, const LawOfScores& law) {
  std::vector<std::vector<double>> scores;
  for (const std::span<const double> sample : {samples.sample, samples.of_next_realisation, samples.of_next_source}) {
    scores.emplace_back(sample.size());
    std::ranges::transform(sample, scores.back().begin(), law.score);
  }
  auto check = check_normal({scores[0], scores[1], scores[2]}, NormalLaw{});
  if (!check) return std::nullopt;
  const CentralMoments moments = central_moments(samples.sample);
  const auto standardised_power = [&law](int power) {
    return expectation(law, [&](double x) { return std::pow((x - law.mean) / law.sigma, power); });
  };
  const double g = std::abs(standardised_power(3)) < 1e-12 ? 0.0 : standardised_power(3);  // of a symmetric law
  const double k = standardised_power(4);
  const std::uint64_t n = moments.n;
  const double deviation = std::sqrt(moments.second * static_cast<double>(n) / static_cast<double>(n - 1));
  check->law = {.mean = law.mean, .sigma = law.sigma};
  check->mean = tested(moments.mean, law.mean, law.sigma, n, law, [](double z) { return z; });
  check->standard_deviation =
      tested(deviation, law.sigma, law.sigma, n, law, [](double z) { return 0.5 * (z * z - 1.0); });
  check->skewness = shape(tested(moments.skewness(), g, 1.0, n, law,
                                 [g](double z) { return z * z * z - 3.0 * z - g - 1.5 * g * (z * z - 1.0); }),
                          g);
  check->kurtosis =
      shape(tested(moments.kurtosis(), k, 1.0, n, law,
                   [g, k](double z) { return z * z * z * z - k - 4.0 * g * z - 2.0 * k * (z * z - 1.0); }),
            k);
  check->histogram = histogram_of(samples.sample, law);
  return check;
}

}  // namespace rocking::stats
