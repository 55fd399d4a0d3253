#include "rocking/stats/normal_check.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/moments.hpp"
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
  if (samples.of_next_realisation.empty()) return tests;
  add("neighbouring_realisations", cross_correlation(samples.sample, samples.of_next_realisation, law));
  add("neighbouring_sources", cross_correlation(samples.sample, samples.of_next_source, law));
  return tests;
}

TailCount tail_beyond(double sigmas, std::span<const double> sample, const NormalLaw& law) {
  const auto outside = [&](double x) { return std::abs(law.score(x)) > sigmas; };
  const auto count = std::count_if(sample.begin(), sample.end(), outside);
  const Proportion beyond{static_cast<std::uint64_t>(count), sample.size()};
  const double probability = 2.0 * normal_cdf(-sigmas);
  return {sigmas, beyond, static_cast<double>(sample.size()) * probability,
          two_sided_binomial_p_value(beyond, probability)};
}

/// Probability between two scores, computed in the tail where it is not a difference of numbers near 1.
double probability_of_bin(double low, double high) {
  return low > 0.0 ? normal_cdf(-low) - normal_cdf(-high) : normal_cdf(high) - normal_cdf(low);
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
                     .dagostino_pearson = dagostino_pearson(sample),
                     .anderson_darling = anderson_darling(sample, law),
                     .kolmogorov_smirnov = kolmogorov_smirnov(sample, law),
                     .tails = normal_tails(sample, law),
                     .histogram = normal_histogram(sample, law, 40, 4.0)};
}

std::optional<NormalCheck> check_own_law(std::span<const double> sample) {
  const auto n = static_cast<double>(sample.size());
  double mean = 0.0;
  for (const double x : sample) mean += x / n;
  double squares = 0.0;
  for (const double x : sample) squares += (x - mean) * (x - mean) / (n - 1.0);
  const double sigma = std::sqrt(squares);
  if (!(sigma >= 1e-70 && sigma <= 1e70)) return std::nullopt;
  auto check = check_normal({sample, {}, {}}, {mean, sigma});
  if (!check) return std::nullopt;
  check->anderson_darling.p_value =
      anderson_darling_p_value_of_own_law(check->anderson_darling.statistic, sample.size());
  check->kolmogorov_smirnov.p_value = lilliefors_p_value(check->kolmogorov_smirnov.statistic, sample.size());
  return check;
}

std::vector<double> p_values_of(const NormalCheck& check) {
  std::vector<double> p_values{check.mean.p_value, check.standard_deviation.p_value, check.skewness.test.p_value,
                               check.kurtosis.test.p_value};
  for (const CorrelationTest& correlation : check.correlations) p_values.push_back(correlation.test.p_value);
  for (const TestOfFit* test : {&check.dagostino_pearson, &check.anderson_darling, &check.kolmogorov_smirnov}) {
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

std::array<TailCount, 3> normal_tails(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(law.sigma > 0.0);
  return {tail_beyond(3.0, sample, law), tail_beyond(4.0, sample, law), tail_beyond(5.0, sample, law)};
}

Histogram normal_histogram(std::span<const double> sample, const NormalLaw& law, std::size_t bins, double reach) {
  ROCKING_EXPECT(bins >= 1 && reach > 0.0 && law.sigma > 0.0);
  const auto n = static_cast<double>(sample.size());
  // Integers first, so that edges k and bins - k have exactly opposite scores and the middle edge is the mean.
  const auto score_of_edge = [&](std::size_t k) {
    return reach * ((2.0 * static_cast<double>(k) - static_cast<double>(bins)) / static_cast<double>(bins));
  };
  Histogram histogram;
  for (std::size_t k = 0; k <= bins; ++k) histogram.edges.push_back(law.mean + law.sigma * score_of_edge(k));
  for (std::size_t k = 0; k < bins; ++k) {
    histogram.expected.push_back(n * probability_of_bin(score_of_edge(k), score_of_edge(k + 1)));
  }
  histogram.expected_below = histogram.expected_above = n * normal_cdf(-reach);
  histogram.counts.resize(bins);
  for (const double x : sample) {
    // Compared with the edges as reported, so that a reader who counts again obtains the same counts.
    const auto upper = std::upper_bound(histogram.edges.begin(), histogram.edges.end(), x);
    if (upper == histogram.edges.begin()) {
      ++histogram.below;
    } else if (upper == histogram.edges.end()) {
      ++histogram.above;
    } else {
      ++histogram.counts[static_cast<std::size_t>(upper - histogram.edges.begin()) - 1];
    }
  }
  return histogram;
}

}  // namespace rocking::stats
