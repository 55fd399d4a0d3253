// Are the draws what they claim to be: independent numbers from N(0, 1)? Every sample has a fixed seed, so a verdict
// never changes; the stated false-alarm probability is that of an honest generator failing with a seed picked blindly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/random/draws.hpp"
#include "rocking/random/engine.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/random/uniform.hpp"
#include "rocking/stats/correlation.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_tails.hpp"
#include "rocking/stats/normality.hpp"

namespace {

using namespace rocking::random;
using namespace rocking::stats;
using Sample = std::vector<double>;

/// Of one comparison. There are fewer than 100 below: 1e-7 for the file, but for Anderson-Darling.
constexpr double false_alarm = 1e-9;
/// A normal score is larger than this with that probability.
constexpr double largest_score = 6.109410;
/// Anderson-Darling's p-value is good to 2e-6 only, so that it is compared with this.
constexpr double anderson_darling_false_alarm = 1e-5;

constexpr std::size_t large = 1000000;

/// Distance of the p-values' empirical law from the uniform one, as a p-value of its own.
double uniformity(std::vector<double> p_values) {
  std::sort(p_values.begin(), p_values.end());
  const auto n = static_cast<double>(p_values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < p_values.size(); ++i) {
    const auto below = static_cast<double>(i);
    distance = std::max({distance, p_values[i] - below / n, (below + 1.0) / n - p_values[i]});
  }
  return kolmogorov_p_value(distance, p_values.size());
}

class Sampler : public ::testing::TestWithParam<SamplerKind> {};

INSTANTIATE_TEST_SUITE_P(All, Sampler,
                         ::testing::Values(SamplerKind::box_muller, SamplerKind::ziggurat, SamplerKind::inverse_cdf),
                         [](const auto& test) {
                           std::string name(to_string(test.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// 500 seeds: a p-value whose law is off by 0.14 anywhere is seen. Jarque-Bera's is off by 0.02 at n = 1000.
TEST_P(Sampler, GivesEveryTestOfFitUniformPValuesOverManySeeds) {
  std::array<std::vector<double>, 4> p_values;
  const NormalLaw law{0.4, 0.03};
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Sample sample = sample_normal(GetParam(), seed, 1000, law.mean, law.sigma);
    p_values[0].push_back(jarque_bera(sample).p_value);
    p_values[1].push_back(dagostino_pearson(sample).p_value);
    p_values[2].push_back(anderson_darling(sample, law).p_value);
    p_values[3].push_back(kolmogorov_smirnov(sample, law).p_value);
  }
  for (std::size_t i = 0; i < p_values.size(); ++i) EXPECT_GT(uniformity(p_values[i]), false_alarm) << i;
}

TEST_P(Sampler, GivesMomentsWithinTheirStandardErrors) {
  const SampleMoments moments = sample_moments(sample_normal(GetParam(), 2012, large, 0.0, 1.0), {}).value();
  EXPECT_LT(std::abs(moments.mean.z), largest_score);
  EXPECT_LT(std::abs(moments.standard_deviation.z), largest_score);
  EXPECT_LT(std::abs(moments.skewness.z), largest_score);
  EXPECT_LT(std::abs(moments.kurtosis.z), largest_score);
}

TEST_P(Sampler, FitsTheLawInALargeSample) {
  const Sample sample = sample_normal(GetParam(), 2012, large, 0.0, 1.0);
  EXPECT_GT(dagostino_pearson(sample).p_value, false_alarm);
  EXPECT_GT(kolmogorov_smirnov(sample, {}).p_value, false_alarm);
  EXPECT_GT(anderson_darling(sample, {}).p_value, anderson_darling_false_alarm);
  for (const TailCount& tail : normal_tails(sample, {})) EXPECT_GT(tail.p_value, false_alarm) << tail.sigmas;
}

TEST_P(Sampler, GivesUncorrelatedNeighbours) {
  const Sample sample = sample_normal(GetParam(), 2012, large, 0.0, 1.0);
  EXPECT_LT(std::abs(pair_correlation(sample, {}).z), largest_score);
  for (const std::size_t lag : {1U, 2U, 3U, 200U}) {
    EXPECT_LT(std::abs(lag_correlation(sample, {}, lag).z), largest_score) << lag;
  }
}

// The two members of a Box-Muller pair share their radius: independent only if the law of the radius is right.
// Squares show it.
TEST_P(Sampler, GivesUncorrelatedSquares) {
  Sample squares = sample_normal(GetParam(), 2012, large, 0.0, 1.0);
  for (double& value : squares) value *= value;
  EXPECT_LT(std::abs(pair_correlation(squares, {1.0, std::numbers::sqrt2}).z), largest_score);
}

/// Correlation of the same `n` indices under two names.
double score_between(const Draws& a, Source source_a, const Draws& b, Source source_b, std::uint64_t shift = 0) {
  Sample interleaved;
  for (std::uint64_t j = 0; j < 100000; ++j) {
    interleaved.push_back(a.standard_normal(source_a, j));
    interleaved.push_back(b.standard_normal(source_b, j + shift));
  }
  return std::abs(pair_correlation(interleaved, {}).z);
}

TEST(Draws, OfNeighbouringNamesAreUncorrelated) {
  const Draws draws(7, 7);
  const Source kinetic = Source::kinetic_friction;
  EXPECT_LT(score_between(draws, kinetic, Draws(8, 7), kinetic), largest_score);
  EXPECT_LT(score_between(draws, kinetic, Draws(7, 8), kinetic), largest_score);
  EXPECT_LT(score_between(draws, kinetic, Draws(7, 7 + (std::uint64_t{1} << 32U)), kinetic), largest_score);
  EXPECT_LT(score_between(draws, kinetic, draws, Source::static_friction), largest_score);
  EXPECT_LT(score_between(draws, kinetic, draws, kinetic, std::uint64_t{1} << 32U), largest_score);
  EXPECT_GT(score_between(draws, kinetic, draws, kinetic), 100.0);  // the twin that must fail: a name twice
}

// A realisation uses few draws of each of many names. Draw 0 of static friction over realisations is what most
// depends on.
TEST(Draws, FitTheLawAcrossRealisationsAndAcrossPairs) {
  Sample across_realisations, across_chatters;
  for (std::uint64_t k = 0; k < 200000; ++k) {
    across_realisations.push_back(Draws(2012, k).standard_normal(Source::static_friction, 0));
    across_chatters.push_back(Draws(2012, 0).standard_normal(Source::restitution, paired_index(k, 0)));
  }
  for (const Sample& sample : {across_realisations, across_chatters}) {
    EXPECT_GT(dagostino_pearson(sample).p_value, false_alarm);
    EXPECT_GT(kolmogorov_smirnov(sample, {}).p_value, false_alarm);
    EXPECT_LT(std::abs(lag_correlation(sample, {}, 1).z), largest_score);
  }
}

TEST(Draws, AreUniformWhereAskedToBe) {
  std::vector<double> numbers;
  for (std::uint64_t k = 0; k < 200000; ++k) numbers.push_back(Draws(2012, k).uniform(Source::phase, 0));
  EXPECT_GT(uniformity(numbers), false_alarm);
  EXPECT_LT(*std::max_element(numbers.begin(), numbers.end()), 1.0);
}

// Sabotaged samplers, each of which the tests must find out.

/// `n` numbers, made one block of two uniform ones after the other.
Sample box_muller_of(std::size_t n, const std::function<double()>& uniform) {
  Sample sample;
  while (sample.size() < n) {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    sample.push_back(radius * std::cos(angle));
    sample.push_back(radius * std::sin(angle));
  }
  return sample;
}

TEST(Sabotage, TheSumOfTwelveUniformNumbersIsFoundOutByItsTails) {
  PhiloxEngine engine(Draws(2012, 0), Source::check_normal);
  Sample sample(large);
  for (double& value : sample) {
    value = -6.0;
    for (int i = 0; i < 12; ++i) value += uniform_from_zero(engine());
  }
  EXPECT_LT(sample_moments(sample, {}).value().kurtosis.z, -largest_score);  // its kurtosis is 2.9
  EXPECT_LT(jarque_bera(sample).p_value, false_alarm);
  EXPECT_LT(dagostino_pearson(sample).p_value, false_alarm);
  EXPECT_LT(normal_tails(sample, {})[0].p_value, false_alarm);
}

TEST(Sabotage, ASpareGivenTwiceIsFoundOutByCorrelation) {
  Sample sample;
  for (std::uint64_t block = 0; sample.size() < 20000; ++block) {
    const NormalPair pair = Draws(2012, 0).standard_normal_pair(Source::check_normal, block);
    sample.insert(sample.end(), {pair.cosine, pair.sine, pair.sine});
  }
  EXPECT_GT(lag_correlation(sample, {}, 1).z, largest_score);
}

TEST(Sabotage, ASpareNeverRenewedIsFoundOutByEveryTest) {
  const NormalPair stale = Draws(2012, 0).standard_normal_pair(Source::check_normal, 0);
  Sample sample = sample_normal(SamplerKind::box_muller, 2012, 20000, 0.0, 1.0);
  for (std::size_t i = 1; i < sample.size(); i += 2) sample[i] = stale.sine;
  EXPECT_LT(kolmogorov_smirnov(sample, {}).p_value, false_alarm);
  EXPECT_LT(anderson_darling(sample, {}).p_value, anderson_darling_false_alarm);
  EXPECT_LT(dagostino_pearson(sample).p_value, false_alarm);
}

// Neave (1973), Appl. Stat. 22, 92-97: neighbours from a multiplicative congruential generator with a small
// multiplier, put through Box-Muller, lie on a spiral; the tails go missing.
TEST(Sabotage, ACongruentialGeneratorIsFoundOutByItsTails) {
  std::uint64_t state = 20120213;
  const auto uniform = [&state] {
    state = 131 * state % (std::uint64_t{1} << 35U);
    return static_cast<double>(state) * 0x1p-35;
  };
  const auto tails = normal_tails(box_muller_of(large, uniform), {});
  EXPECT_LT(std::min({tails[0].p_value, tails[1].p_value, tails[2].p_value}), false_alarm);
}

TEST(Sabotage, OneUniformNumberForRadiusAndAngleIsFoundOut) {
  PhiloxEngine engine(Draws(2012, 0), Source::check_normal);
  double shared = 0.0;
  bool fresh = false;
  const auto uniform = [&] {
    fresh = !fresh;
    if (fresh) shared = uniform_to_one(engine());
    return shared;
  };
  EXPECT_LT(kolmogorov_smirnov(box_muller_of(20000, uniform), {}).p_value, false_alarm);
}

TEST(Sabotage, AShiftOfATwentiethOfSigmaIsFoundOutInALargeSample) {
  const Sample sample = sample_normal(SamplerKind::box_muller, 2012, large, 0.05, 1.0);
  EXPECT_LT(kolmogorov_smirnov(sample, {}).p_value, false_alarm);
  EXPECT_LT(anderson_darling(sample, {}).p_value, anderson_darling_false_alarm);
  EXPECT_GT(sample_moments(sample, {}).value().mean.z, largest_score);
}

}  // namespace
