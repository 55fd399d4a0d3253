// What a run of a suite, and rare estimates of it, are for its curves.

#include <numbers>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/api/run_store.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/studies/curves/annual_rate.hpp"
#include "rocking/studies/curves/stripes.hpp"
#include "rocking/studies/rare/study.hpp"
#include "support/constant_suite.hpp"

namespace rocking {
namespace {

/// The same two records and block at these scales.
Experiment suite_at(std::vector<double> scales) {
  support::SplitMix random(3);
  return support::ConstantSuite{.records = 2, .levels = std::move(scales), .realisations = 4}.drawn(random);
}

TEST(Stripes, OfASuiteStandInOneGroup) {
  Experiment experiment = suite_at({0.5, 0.8});
  const RunResult done = run(experiment);
  const std::vector<StripeGroup> groups = stripes_of(experiment, store_of(done));
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_TRUE(groups[0].others.empty());
  EXPECT_EQ(groups[0].by_record().size(), 2U);
  EXPECT_EQ(groups[0].stripes.size(), 4U);
  // That at 2 pi/p is a measure of its own.
  const Scene& scene = experiment.conditions.front().scene;
  const double own = 2.0 * std::numbers::pi / dynamics::geometry_of(mean_block(scene)).frequency_parameter;
  for (const double period : {own, 0.5 * own}) {
    for (Condition& condition : experiment.conditions)
      std::get<Recorded>(condition.scene.excitation).measure_periods = {period};
    const Stripe stripe = stripes_of(experiment, store_of(done)).front().stripes.front();
    EXPECT_EQ(stripe.measure(IntensityMeasure::sa).has_value(), period != own);
  }
}

TEST(RareLevels, OfASuiteAreTheMeansOverItsRecordsAtEachIntensity) {
  const Experiment weak = suite_at({0.2, 0.25});
  const RareQuestion request{.relative_error = 1.0, .particles = 50};
  const std::string text = rare_document().text(rare_report(weak, request, rare_probabilities(weak, request)));
  const std::vector<RareOfCurve> levels = rare_levels(text, "rare.json", suite_at({0.5, 0.8}));
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_NE(levels[0].level.intensity, levels[1].level.intensity);
  for (const RareOfCurve& found : levels) {
    EXPECT_TRUE(found.others.empty());
    ASSERT_EQ(found.records.size(), 2U);
    const double sum = found.records[0].level.probability + found.records[1].level.probability;
    EXPECT_NEAR(found.level.probability, 0.5 * sum, 1e-15);
  }
}

}  // namespace
}  // namespace rocking
