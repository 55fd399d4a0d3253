#include "rocking/random/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <boost/math/special_functions/erf.hpp>
#include <gtest/gtest.h>

#include "rocking/random/draws.hpp"
#include "rocking/random/uniform.hpp"
#include "support/normal_samples.hpp"

namespace {

using namespace rocking::random;
using rocking::support::sample_of;

constexpr SamplerKind all_kinds[] = {SamplerKind::box_muller, SamplerKind::ziggurat, SamplerKind::inverse_cdf};

static_assert(std::uniform_random_bit_generator<PhiloxEngine>);

class Sampler : public ::testing::TestWithParam<SamplerKind> {};

TEST_P(Sampler, IsFoundByItsName) { EXPECT_EQ(sampler_from_string(to_string(GetParam())), GetParam()); }

TEST_P(Sampler, GivesTheSameSampleToTheSameSeedAndAnotherToAnother) {
  const std::vector<double> sample = sample_of(GetParam(), 8, 100);
  EXPECT_EQ(sample_of(GetParam(), 8, 100), sample);
  EXPECT_NE(sample_of(GetParam(), 9, 100), sample);
}

TEST_P(Sampler, BeginsALongerSampleWithTheShorterOne) {
  const std::vector<double> longer = sample_of(GetParam(), 8, 1001);
  for (const std::size_t n : {0U, 1U, 2U, 7U, 1000U}) {
    const std::vector<double> shorter = sample_of(GetParam(), 8, n);
    ASSERT_EQ(shorter.size(), n);
    EXPECT_TRUE(std::equal(shorter.begin(), shorter.end(), longer.begin())) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Sampler, ::testing::ValuesIn(all_kinds), [](const auto& test) {
  std::string name(to_string(test.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(SamplerNames, AreThoseThatUsersWrite) {
  EXPECT_EQ(sampler_from_string("box-muller"), SamplerKind::box_muller);
  EXPECT_EQ(sampler_from_string("ziggurat"), SamplerKind::ziggurat);
  EXPECT_EQ(sampler_from_string("inverse-cdf"), SamplerKind::inverse_cdf);
  EXPECT_EQ(sampler_from_string("box_muller"), std::nullopt);
  EXPECT_EQ(sampler_from_string(""), std::nullopt);
}

TEST(SamplerBoxMuller, IsWhatRealisationsDraw) {
  const Draws draws(77, 0);
  const std::vector<double> sample = sample_of(SamplerKind::box_muller, 77, 9);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    EXPECT_EQ(sample[i], draws.standard_normal(Source::check_normal, i));
  }
}

TEST(SamplerInverseCdf, InvertsTheDistributionFunction) {
  const Draws draws(77, 0);
  const std::vector<double> sample = sample_of(SamplerKind::inverse_cdf, 77, 1000);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double probability = 0.5 * boost::math::erfc(-sample[i] / std::sqrt(2.0));
    EXPECT_NEAR(probability, uniform_inside(draws.bits(Source::check_normal, i)), 1e-14) << i;
  }
}

TEST(PhiloxEngine, WalksAlongTheIndicesAndCanBeSentAnywhere) {
  const Draws draws(3, 4);
  PhiloxEngine engine(draws, Source::check_normal);
  for (std::uint64_t i = 0; i < 10; ++i) EXPECT_EQ(engine(), draws.bits(Source::check_normal, i));
  EXPECT_EQ(engine.index(), 10U);
  engine.seek(1000003);
  EXPECT_EQ(engine(), draws.bits(Source::check_normal, 1000003));
}

}  // namespace
