// A surface over two measures: what lies outside the tested points, and its rate.

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/probit_surface.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

using stats::FragilityOutcome;
using stats::SurfaceCoefficients;
using ::testing::HasSubstr;

/// Twelve records at five levels of PGA, each with a ratio PGV/PGA of its own; those with a large one overturn earlier.
StripeGroup group_of_twelve(int (*overturned)(double pga, double ratio)) {
  StripeGroup group{.parameter = "/excitation/pga_g", .others = {}, .confidence = 0.95, .stripes = {}};
  for (int record = 0; record < 12; ++record) {
    const double ratio = 0.05 * std::exp(0.1 * record);
    for (const double pga : {0.2, 0.3, 0.45, 0.6, 0.9}) {
      Stripe& stripe = group.stripes.emplace_back();
      stripe.record = "r" + std::to_string(record);
      stripe.intensity = pga;
      stripe.measures[static_cast<std::size_t>(IntensityMeasure::pga)] = pga;
      stripe.measures[static_cast<std::size_t>(IntensityMeasure::sa_p)] = 4.0 * pga;
      stripe.pgv_over_pga = ratio;
      for (int j = 0; j < 10; ++j) stripe.overturned.push_back(j < overturned(pga, ratio));
      stripe.peaks.resize(10);
      stripe.uplift = 0.25;
    }
  }
  return group;
}

int by_both(double pga, double ratio) {
  const double scatter = 0.6 * std::sin(1000.0 * ratio);
  return static_cast<int>(
      std::lround(10.0 * stats::normal_cdf(2.0 * std::log(pga / 0.45) + 1.5 * std::log(ratio / 0.085) + scatter)));
}

const std::vector<std::string> both{"pga_g", "pgv_over_pga_s"};

FragilitySurface surface_of(const StripeGroup& group, const std::vector<std::string>& measures = both,
                            const std::optional<JointHazard>& hazard = std::nullopt) {
  return fragility_surface(group, suite_curve(group, {}, 1), measures, hazard);
}

TEST(FragilitySurface, SaysWhetherTheSecondMeasureMattersAndWhereTheMediansAre) {
  const FragilitySurface found = surface_of(group_of_twelve(by_both));
  ASSERT_EQ(found.outcome, FragilityOutcome::fitted);
  EXPECT_LE(found.second->p_value.value(), 0.05);
  const SurfaceMedian &low = found.medians.at(0), &high = found.medians.at(1);
  EXPECT_LT(low.y, high.y);
  EXPECT_GT(*low.x, *high.x);
  const SurfaceCoefficients c = found.values();
  const double v = std::log(low.y / found.centre[1]);
  EXPECT_NEAR(stats::surface_probit(c, std::log(*low.x / found.centre[0]), v), 0.0, 1e-12);
  EXPECT_TRUE(low.interval && low.interval->low < *low.x && *low.x < low.interval->high);
  EXPECT_THAT(surface_table("", found), HasSubstr("surface of overturning: pgv_over_pga_s matters beside pga_g (p = "));
  FragilitySurface untested = found;
  untested.second->p_value.reset();
  EXPECT_THAT(surface_table("", untested), HasSubstr("pgv_over_pga_s is not tested beside pga_g (no p: too few"));
}

// All levels have all ratios: nothing of the rectangle between the extremes is extrapolated.
TEST(FragilitySurface, KnowsWhatLiesOutsideTheTestedPoints) {
  StripeGroup group = group_of_twelve(by_both);
  for (const SurfacePoint& point : surface_of(group).map)
    EXPECT_FALSE(point.is_extrapolated) << point.x << ' ' << point.y;
  std::erase_if(group.stripes,
                [](const Stripe& stripe) { return stripe.intensity > 0.5 && *stripe.pgv_over_pga > 0.1; });
  const FragilitySurface cut = surface_of(group);
  EXPECT_FALSE(cut.map.front().is_extrapolated);
  EXPECT_TRUE(cut.map.back().is_extrapolated);
}

TEST(FragilitySurface, GivesTheRateOfAJointHazardFromTheLeastUpliftOn) {
  const StripeGroup group = group_of_twelve(by_both);
  const JointHazard hazard{
      .name = "j.csv",
      .cells = {{0.24, 0.08, 1e-2}, {0.25, 0.08, 2e-3}, {0.45, 0.08, 1e-3}, {0.6, 0.1, 1e-4}, {2.0, 0.1, 1e-5}}};
  const FragilitySurface found = surface_of(group, both, hazard);
  const auto part = [&](std::size_t i) {
    const auto [x, y, rate] = hazard.cells[i];
    return rate * stats::normal_cdf(stats::surface_probit(found.values(), std::log(x / found.centre[0]),
                                                          std::log(y / found.centre[1])));
  };
  const double sum = part(1) + part(2) + part(3) + part(4);  // the first cell lies below the least uplift
  EXPECT_NEAR(found.rate->value, sum, 1e-12 * sum);
  EXPECT_NEAR(found.rate->extrapolated_share, part(4) / sum, 1e-9);
  EXPECT_TRUE(found.rate->interval->low < sum && sum < found.rate->interval->high);
}

TEST(FragilitySurface, IsNoneWithoutReason) {
  EXPECT_EQ(surface_of(group_of_twelve([](double, double) { return 0; })).outcome, FragilityOutcome::never_happened);
  const auto step = [](double pga, double ratio) { return pga * ratio > 0.04 ? 10 : 0; };
  const FragilitySurface separated = surface_of(group_of_twelve(step));
  EXPECT_EQ(separated.outcome, FragilityOutcome::separated);
  EXPECT_THAT(surface_table("", separated), HasSubstr("none is fitted: a line parts the points"));
  const StripeGroup group = group_of_twelve(by_both);
  EXPECT_EQ(surface_of(group, {"pga_g", "sa_p_g"}).outcome, FragilityOutcome::too_little);
  EXPECT_THROW(static_cast<void>(surface_of(group, {"pga_g", "sa_g"})), base::InputError);
}

/// What is wrong with a file of this text.
std::string fault_in(const std::string& text) {
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder / "j.csv";
  std::ofstream(file) << text;
  try {
    static_cast<void>(joint_hazard(file, both));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JointHazard, IsReadWithColumnsInAnyOrderAndItsFaultsWithTheirLine) {
  EXPECT_EQ(fault_in("annual_rate,pgv_over_pga_s,pga_g\n# cells\n1e-3,0.1,0.3\n"), "");
  EXPECT_THAT(fault_in("pga_g,annual_rate\n0.1,1e-3\n"), HasSubstr("j.csv, line 1"));
  EXPECT_THAT(fault_in("pga_g,pgv_over_pga_s,annual_rate\n0.3,0.1,1e-3\n0.3,0.1,-1e-3\n"), HasSubstr("j.csv, line 3"));
  EXPECT_THAT(fault_in("pga_g,pgv_over_pga_s,annual_rate\n0.3,0.1,1e-3\n0.3,0.1,1e-4\n"), HasSubstr("stands twice"));
  EXPECT_THAT(fault_in("pga_g,pgv_over_pga_s,annual_rate\n0.3,x,1e-3\n"), HasSubstr("line 2"));
  EXPECT_THAT(fault_in("pga_g,pgv_over_pga_s,annual_rate\n"), HasSubstr("has no cell with a rate above 0"));
}

}  // namespace
}  // namespace rocking
