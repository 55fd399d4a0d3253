// Whether blocks still stand: one, several under the same motions, and under several hazard curves.

#include <cmath>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "support/made_up_suite.hpp"

namespace rocking {
namespace {

using namespace support::six_records;
using ::testing::HasSubstr;

constexpr double years = 1000.0;

/// A suite, with the stripes from which it follows.
struct Block {
  explicit Block(const std::vector<std::vector<int>>& counts, const ResponseEvent& event = {})
      : group(group_of(counts)), curve(suite_curve(group, event, 1)) {}
  [[nodiscard]] BlockCurve named(const std::string& name) const {
    return {.name = name, .curve = &curve, .group = &group};
  }
  StripeGroup group;
  SuiteCurve curve;
};

/// H = 1e-5 x^-2.
HazardCurve tenth() {
  HazardCurve curve = hazard();
  curve.name = "tenth";
  for (HazardPoint& point : curve.points) point.rate *= 0.1;
  return curve;
}

/// Every record at every level all or nothing.
const std::vector<std::vector<int>> sure{{0, 0, 10, 10, 10}, {0, 0, 0, 10, 10},  {0, 10, 10, 10, 10},
                                         {0, 0, 0, 0, 10},   {0, 0, 10, 10, 10}, {0, 0, 0, 0, 0}};
const std::vector<std::vector<int>> never(6, {0, 0, 0, 0, 0});

TEST(Survival, OfOneBlockIsTheExponentialOfItsRate) {
  const Block block(outcomes);
  const Survival found = survival({block.named("a")}, years, {hazard()}, 1);
  const AnnualRate rate = annual_rate(block.curve, hazard()).chosen;
  const SurvivalBranch& branch = found.branches.at(0);
  EXPECT_EQ(branch.all.rate, rate.value);
  EXPECT_EQ(branch.all.probability, std::exp(-rate.value * years));
  EXPECT_EQ(branch.all.interval->low, std::exp(-rate.interval->high * years));
  EXPECT_EQ(branch.all.interval->high, std::exp(-rate.interval->low * years));
  EXPECT_EQ(branch.independent, branch.all.probability);
  EXPECT_EQ(branch.weight, 1.0);
  EXPECT_THAT(survival_table(found), HasSubstr("probability that the block has not overturned in 1000 years: "));
}

// Where a record overturns one it overturns the other: two such blocks survive as one does.
TEST(Survival, OfBlocksThatFallTogetherIsThatOfOne) {
  const Block first(sure), second(sure);
  const SurvivalBranch branch = survival({first.named("a"), second.named("b")}, years, {hazard()}, 1).branches.at(0);
  EXPECT_NEAR(branch.all.rate, branch.blocks.at(0).rate, 1e-12 * branch.all.rate);
  EXPECT_NEAR(branch.independent, branch.all.probability * branch.all.probability, 1e-12);
  EXPECT_LT(branch.independent, 0.9 * branch.all.probability);
}

// Given the record the blocks are independent: at each level the mean over the records of 1 - (1 - p)^2. All 1000
// combinations of ten realisations of three blocks are trials. One that never overturns has no law, so that the rates are
// those of the shares.
TEST(Survival, CombinesSharesRecordByRecord) {
  const Block block(outcomes), other(outcomes), third(never);
  const Survival found = survival({block.named("a"), other.named("b"), third.named("c")}, years, {hazard()}, 1);
  ASSERT_EQ(found.source, RateSource::isotonic);
  std::vector<double> shares(intensities.size(), 0.0);
  for (const std::vector<int>& record : outcomes) {
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double stands = 1.0 - record[k] / 10.0;
      shares[k] += (1.0 - stands * stands) / static_cast<double>(outcomes.size());
    }
  }
  const double rate = midpoint_rate([&](double x) { return interpolated(shares, x); });
  EXPECT_NEAR(found.branches.at(0).all.rate, rate, 1e-6 * rate);
  EXPECT_EQ(found.branches.at(0).blocks.at(2).probability, 1.0);
  const std::string text = survival_table(found);
  EXPECT_THAT(text, HasSubstr("none of 3 blocks has overturned in 1000 years"));
}

TEST(Survival, WeighsHazardCurvesByTheirLikelihoods) {
  const Block block(outcomes);
  const auto branches = survival({block.named("a")}, years, {hazard(), tenth()}, 1).branches;
  EXPECT_NEAR(branches.at(0).weight + branches.at(1).weight, 1.0, 1e-15);
  EXPECT_NEAR(branches.at(1).weight / branches.at(0).weight,
              std::exp((branches.at(0).all.rate - branches.at(1).all.rate) * years), 1e-10);
  EXPECT_NEAR(branches.at(1).all.rate, 0.1 * branches.at(0).all.rate, 1e-12);
}

TEST(Survival, IsRefusedWithoutCommonMotions) {
  Block block(outcomes), other(outcomes);
  other.group.stripes.back().record = "another";
  EXPECT_THROW(static_cast<void>(survival({block.named("a"), other.named("b")}, years, {hazard()}, 1)),
               base::InputError);
  other.group.stripes.pop_back();
  EXPECT_THROW(static_cast<void>(survival({block.named("a"), other.named("b")}, years, {hazard()}, 1)),
               base::InputError);
}

}  // namespace
}  // namespace rocking
