// Sabotaged samplers. The tests that good draws pass (random_normal_test.cpp) must detect each of them. Every sample
// has a fixed seed, so that the result never changes.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/random/draws.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/random/uniform.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_check.hpp"
#include "support/normal_samples.hpp"

namespace {

using namespace rocking::random;
using namespace rocking::stats;
using namespace rocking::support;

/// `n` numbers, each pair made from two uniform numbers.
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

/// Sums of twelve uniform numbers less six: mean 0, variance 1, kurtosis 2.9, nothing beyond 6.
Sample sums_of_twelve(std::size_t n, std::uint64_t seed) {
  PhiloxEngine engine(Draws(seed, 0), Source::check_normal);
  Sample sample(n);
  for (double& value : sample) {
    value = -6.0;
    for (int i = 0; i < 12; ++i) value += uniform_from_zero(engine());
  }
  return sample;
}

// Kurtosis -0.1 from normal: 1.44 standard errors of a sample of 5000.
TEST(Sabotage, TheSumOfTwelveUniformNumbersHasNoUniformPValues) {
  FalseAlarms alarms;
  const auto found = uniformities(200, [](std::uint64_t seed) { return check_of(sums_of_twelve(5000, seed)); });
  EXPECT_LT(found[3], false_alarm) << "kurtosis";
  EXPECT_GT(found[0], alarms.level()) << "the mean is right";
}

TEST(Sabotage, TheSumOfTwelveUniformNumbersIsFoundOutByItsTails) {
  const NormalCheck check = check_of(sums_of_twelve(large, 2012));
  EXPECT_LT(check.kurtosis.test.moment.z, -largest_score);
  EXPECT_LT(check.dagostino_pearson.p_value, false_alarm);
  EXPECT_LT(check.tails[0].p_value, false_alarm);
  EXPECT_TRUE(is_refuted(check));
}

TEST(Sabotage, ASpareGivenTwiceIsFoundOutByCorrelation) {
  Sample sample;
  for (std::uint64_t block = 0; sample.size() < 20000; ++block) {
    const NormalPair pair = Draws(2012, 0).standard_normal_pair(Source::check_normal, block);
    sample.insert(sample.end(), {pair.cosine, pair.sine, pair.sine});
  }
  const NormalCheck check = check_of(sample);
  EXPECT_GT(check.correlations[2].test.moment.z, largest_score) << check.correlations[2].between;
  EXPECT_TRUE(is_refuted(check));
}

// Uses the second number of the previous pair: each number occurs twice, three places apart.
TEST(Sabotage, ASpareOfThePairBeforeIsFoundOutByALag) {
  Sample sample;
  double spare = 0.0;
  for (std::uint64_t block = 0; sample.size() < 20000; ++block) {
    const NormalPair pair = Draws(2012, 0).standard_normal_pair(Source::check_normal, block);
    sample.insert(sample.end(), {pair.sine, spare});
    spare = pair.sine;
  }
  const NormalCheck check = check_of(sample);
  EXPECT_EQ(check.correlations[4].between, "lag_3");
  EXPECT_GT(check.correlations[4].test.moment.z, largest_score);
  EXPECT_TRUE(is_refuted(check));
}

TEST(Sabotage, ASpareNeverRenewedIsFoundOutByEveryTest) {
  const NormalPair stale = Draws(2012, 0).standard_normal_pair(Source::check_normal, 0);
  Sample sample = sample_of(SamplerKind::box_muller, 2012, 20000);
  for (std::size_t i = 1; i < sample.size(); i += 2) sample[i] = stale.sine;
  const NormalCheck check = check_of(sample);
  EXPECT_LT(check.kolmogorov_smirnov.p_value, false_alarm);
  EXPECT_LT(check.anderson_darling.p_value, 1e-7);  // the p-value at this size is at least 3e-8
  EXPECT_LT(check.dagostino_pearson.p_value, false_alarm);
  EXPECT_TRUE(is_refuted(check));
}

// Neave (1973), Appl. Stat. 22, 92-97: successive numbers of a multiplicative congruential generator with a small
// multiplier, transformed by Box-Muller, lie on a spiral; the tails are missing.
TEST(Sabotage, ACongruentialGeneratorIsFoundOutByItsTails) {
  std::uint64_t state = 20120213;
  const auto uniform = [&state] {
    state = 131 * state % (std::uint64_t{1} << 35U);
    return static_cast<double>(state) * 0x1p-35;
  };
  const NormalCheck check = check_of(box_muller_of(large, uniform));
  EXPECT_LT(std::min({check.tails[0].p_value, check.tails[1].p_value, check.tails[2].p_value}), false_alarm);
  EXPECT_TRUE(is_refuted(check));
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
  const NormalCheck check = check_of(box_muller_of(20000, uniform));
  EXPECT_LT(check.kolmogorov_smirnov.p_value, false_alarm);
  EXPECT_TRUE(is_refuted(check));
}

// Each number is normal, and no two are correlated; only their squares show the fault.
TEST(Sabotage, ASpareThatIsTheFirstNumberWithASignOfItsOwnIsFoundOutBySquares) {
  FalseAlarms alarms;
  PhiloxEngine engine(Draws(2012, 1), Source::check_normal);
  Sample sample = sample_of(SamplerKind::box_muller, 2012, 20000);
  for (std::size_t i = 1; i < sample.size(); i += 2) sample[i] = engine() % 2 == 0 ? sample[i - 1] : -sample[i - 1];
  const NormalCheck check = check_of(sample);
  EXPECT_GT(check.correlations[1].test.moment.z, largest_score);
  EXPECT_GT(check.kolmogorov_smirnov.p_value, alarms.level());
  EXPECT_LT(std::abs(check.correlations[0].test.moment.z), alarms.score());
}

TEST(Sabotage, AShiftOfATwentiethOfSigmaIsFoundOutInALargeSample) {
  Sample sample = sample_of(SamplerKind::box_muller, 2012, large);
  for (double& number : sample) number += 0.05;
  const NormalCheck check = check_of(sample);
  EXPECT_LT(check.kolmogorov_smirnov.p_value, false_alarm);
  EXPECT_LT(check.anderson_darling.p_value, 1e-9);  // the p-value at this size is at least 6e-10
  EXPECT_GT(check.mean.moment.z, largest_score);
  EXPECT_TRUE(is_refuted(check));
}

// Realisations 2k and 2k + 1 then have the same random numbers.
TEST(Sabotage, RealisationsThatLoseTheirLowestBitAreFoundOut) {
  Sample across;
  for (std::uint64_t k = 0; k < 100000; ++k) {
    across.push_back(Draws(2012, k - k % 2).standard_normal(Source::static_friction, 0));
  }
  EXPECT_GT(lag_correlation(across, {}, 1).z, largest_score);
  const Sample sample = sample_of(SamplerKind::box_muller, 2012, 20000);
  const Sample other = sample_of(SamplerKind::box_muller, 2013, 20000);
  EXPECT_TRUE(is_refuted(check_normal({sample, sample, other}, {}).value()));
  EXPECT_TRUE(is_refuted(check_normal({sample, other, sample}, {}).value()));
}

TEST(Sabotage, UniformNumbersThatStopShortAreFoundOut) {
  std::vector<double> numbers;
  for (std::uint64_t k = 0; k < 200000; ++k) numbers.push_back(0.98 * Draws(2012, k).uniform(Source::phase, 0));
  EXPECT_LT(uniformity(numbers), false_alarm);
}

}  // namespace
