#include "rocking/stats/normal_check.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/anderson_darling.hpp"
#include "rocking/stats/correlation.hpp"
#include "rocking/stats/kolmogorov_smirnov.hpp"
#include "rocking/stats/normality.hpp"

namespace rocking::stats {
namespace {

MomentTest tested_by_score(const Moment& moment, double score) { return {moment, two_sided_normal_p_value(score)}; }

/// (n - 1) s^2/sigma^2 follows a chi-squared law of n - 1 degrees, exactly.
MomentTest tested_by_chi_squared(const Moment& standard_deviation, const NormalLaw& law, std::size_t n) {
  const double half_degrees = 0.5 * static_cast<double>(n - 1);
  const double ratio = standard_deviation.value / law.sigma;
  const double x = half_degrees * ratio * ratio;
  const double tail = std::min(boost::math::gamma_p(half_degrees, x), boost::math::gamma_q(half_degrees, x));
  return {standard_deviation, std::min(1.0, 2.0 * tail)};
}

using NormalScore = double (*)(double, std::size_t);

ShapeTest tested_shape(const Moment& moment, double value_of_law, NormalScore score, std::size_t n) {
  const auto near = [&](double distance) -> Nearness {
    const double low = score(value_of_law - distance, n);
    const double high = score(value_of_law + distance, n);
    return {distance, normal_cdf(high) - normal_cdf(low)};
  };
  return {.test = tested_by_score(moment, score(moment.value, n)),
          .nearness = {near(0.01), near(std::abs(moment.value - value_of_law))}};
}

std::vector<CorrelationTest> correlations(const NormalSamples& samples, const NormalLaw& law) {
  std::vector<CorrelationTest> tests;
  const auto add = [&tests](const std::string& between, const Moment& moment) {
    tests.push_back({between, tested_by_score(moment, moment.z)});
  };
  add("members_of_a_pair", pair_correlation(samples.sample, law));
  add("squares_in_a_pair", pair_correlation_of_squares(samples.sample, law));
  for (const std::size_t lag : {1U, 2U, 3U, 200U}) {  // 200: a period of the excitation, in draws of kinetic friction
    if (lag < samples.sample.size()) add("lag_" + std::to_string(lag), lag_correlation(samples.sample, law, lag));
  }
  add("neighbouring_realisations", cross_correlation(samples.sample, samples.of_next_realisation, law));
  add("neighbouring_sources", cross_correlation(samples.sample, samples.of_next_source, law));
  return tests;
}

}  // namespace

std::optional<NormalCheck> check_normal(const NormalSamples& samples, const NormalLaw& law) {
  const std::span<const double> sample = samples.sample;
  ROCKING_EXPECT(sample.size() >= 20);
  const auto moments = sample_moments(sample, law);
  if (!moments) return std::nullopt;
  return NormalCheck{.law = law,
                     .n = moments->n,
                     .mean = tested_by_score(moments->mean, moments->mean.z),
                     .standard_deviation = tested_by_chi_squared(moments->standard_deviation, law, sample.size()),
                     .skewness = tested_shape(moments->skewness, 0.0, skewness_score, sample.size()),
                     .kurtosis = tested_shape(moments->kurtosis, 3.0, kurtosis_score, sample.size()),
                     .correlations = correlations(samples, law),
                     .jarque_bera = jarque_bera(sample),
                     .dagostino_pearson = dagostino_pearson(sample),
                     .anderson_darling = anderson_darling(sample, law),
                     .kolmogorov_smirnov = kolmogorov_smirnov(sample, law),
                     .tails = normal_tails(sample, law),
                     .histogram = normal_histogram(sample, law, 40, 4.0)};
}

std::vector<double> p_values_of(const NormalCheck& check) {
  std::vector<double> p_values{check.mean.p_value, check.standard_deviation.p_value, check.skewness.test.p_value,
                               check.kurtosis.test.p_value};
  for (const CorrelationTest& correlation : check.correlations) p_values.push_back(correlation.test.p_value);
  for (const TestOfFit* test :
       {&check.jarque_bera, &check.dagostino_pearson, &check.anderson_darling, &check.kolmogorov_smirnov}) {
    p_values.push_back(test->p_value);
  }
  for (const TailCount& tail : check.tails) p_values.push_back(tail.p_value);
  return p_values;
}

SmallestPValue smallest_p_value(const NormalCheck& check) {
  const std::vector<double> p_values = p_values_of(check);
  const double smallest = *std::ranges::min_element(p_values);
  return {.value = smallest,
          .tests = p_values.size(),
          .probability = -std::expm1(static_cast<double>(p_values.size()) * std::log1p(-smallest))};
}

bool is_refuted(const NormalCheck& check) {
  constexpr double significance = 1e-6;
  std::vector<double> p_values{check.anderson_darling.p_value, check.kolmogorov_smirnov.p_value};
  if (!check.skewness.of_law) {
    p_values.push_back(check.mean.p_value);
    p_values.push_back(check.standard_deviation.p_value);
  }
  for (const TailCount& tail : check.tails) p_values.push_back(tail.p_value);
  if (check.n >= 1000) {
    for (const CorrelationTest& correlation : check.correlations) {
      if (correlation.between != "squares_in_a_pair") p_values.push_back(correlation.test.p_value);
    }
  }
  return std::any_of(p_values.begin(), p_values.end(), [](double p) { return p < significance; });
}

}  // namespace rocking::stats
