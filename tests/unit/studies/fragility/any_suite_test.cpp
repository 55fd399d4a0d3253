// Whatever a small suite shows, its fragility can be written, read again, and looked at: an end of an interval that does not
// exist is `unbounded`, and no number is none.

#include <cmath>

#include <gmock/gmock.h>

#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/json.hpp"
#include "support/made_up_suite.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Records that fall from some level on, or nearly; some never do, some always.
StripeGroup random_suite(support::SplitMix& random) {
  const auto below = [&random](double most) { return static_cast<std::size_t>(random.uniform(0.0, most)); };
  StripeGroup group{.parameter = "/excitation/scale", .others = {}, .confidence = 0.95, .stripes = {}};
  const std::size_t records = 1 + below(4.0), trials = 1 + below(4.0);
  const std::size_t levels = below(4.0) == 0 ? 50 : 1 + below(8.0);
  const double noise = below(2.0) == 0 ? 0.0 : 0.2;
  for (std::size_t r = 0; r < records; ++r) {
    const double capacity = random.uniform(-0.2, 1.2) * static_cast<double>(levels);
    for (std::size_t k = 0; k < levels; ++k) {
      Stripe& stripe = group.stripes.emplace_back();
      stripe.record = "r" + std::to_string(r);
      stripe.intensity = 0.01 * static_cast<double>(k + 1);
      stripe.uplift = 0.01;
      for (std::size_t j = 0; j < trials; ++j) {
        const bool falls = static_cast<double>(k) > capacity;
        stripe.overturned.push_back(random.uniform(0.0, 1.0) < noise ? !falls : falls);
      }
      stripe.peaks.resize(trials);
    }
  }
  return group;
}

/// Of a suite, with its annual rate.
RunFragility fragility_of(const StripeGroup& group) {
  RunFragility found{.experiment = {}};
  ShownSuite& shown = found.suites.emplace_back(ShownSuite{.curve = suite_curve(group, {}, 1)});
  shown.rate = annual_rate(shown.curve, support::six_records::hazard());
  shown.rate->chosen.in_years = in_years(shown.rate->chosen, {50.0});
  return found;
}

TEST(FragilityOfAnySuite, IsWrittenReadAndShown) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(seed);
    support::SplitMix random(seed);
    const StripeGroup group = random_suite(random);
    if (!group.is_suite()) continue;
    const std::string text = fragility_document().text(fragility_report({fragility_of(group)}));
    FragilityReport again;
    ASSERT_NO_THROW(again = fragility_document().read(parse_json(text)));
    std::string shown = fragility_table(again);
    for (const StudyTable& table : fragility_tables(again)) shown += to_csv(table.table) + to_latex(table.table, "");
    EXPECT_THAT(shown, AllOf(Not(HasSubstr("inf")), Not(HasSubstr("nan")), Not(HasSubstr("[unbounded"))));
    EXPECT_NO_THROW(static_cast<void>(fragility_study().figures(parse_json(text), {})));
  }
}

/// Two records of 150 levels, of which one falls early and the other late.
TEST(FragilityOfAnySuite, OfTwoRecordsHasIntervalsWithoutAnEnd) {
  StripeGroup group{.parameter = "/excitation/scale", .others = {}, .confidence = 0.95, .stripes = {}};
  for (const auto& [name, capacity] : {std::pair{"a", 0.85}, std::pair{"b", 1.3}}) {
    for (int k = 1; k <= 150; ++k) {
      Stripe& stripe = group.stripes.emplace_back();
      stripe.record = name;
      stripe.intensity = 0.01 * k;
      stripe.uplift = 0.01;
      for (int j = -1; j <= 1; ++j) stripe.overturned.push_back(stripe.intensity > capacity + 0.004 * j);
      stripe.peaks.resize(3);
    }
  }
  const SuiteCurve curve = suite_curve(group, {}, 1);
  ASSERT_TRUE(curve.pooled);
  EXPECT_EQ(curve.pooled->median.interval.low, 0.0);
  EXPECT_TRUE(std::isinf(curve.pooled->median.interval.high));
  EXPECT_GT(curve.pooled->dispersion.interval.low, 0.0);
  EXPECT_TRUE(std::isinf(curve.pooled->between_records.interval.high));
}

}  // namespace
}  // namespace rocking
