// The figure of settling where nothing has settled.

#include "analysis/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "analysis/figure_scripts.hpp"
#include "rocking/output/report.hpp"
#include "support/sample_report.hpp"

namespace {

using namespace rocking;
using namespace rocking::analysis;
using rocking::support::sample_report;
using ::testing::HasSubstr;
using ::testing::Not;

/// A run with `until_classified` of which no realisation settled; `limit` in excitation periods.
Report unsettled(std::int64_t limit) {
  Report report = report_in(sample_report());
  for (ReportedCondition& condition : report.conditions) {
    condition.result.modes = {{.mode = {}, .probability = support::sample_estimate(30, 30)}};
    condition.asked.horizon.until_classified = {.at_most_periods = limit, .held_windows = 2};
    SettlingResult& settling = condition.result.settling.emplace();
    settling.censored = 30;
    settling.at_horizon[{}] = 30;
  }
  return report;
}

TEST(IncidenceFigure, DrawsWhatNeverSettledUpToTheEndOfItsObservation) {
  for (const std::int64_t limit : {625, 1000, 200000}) {
    const Report report = unsettled(limit);
    const Figure figure = incidence_figure(report).value();
    ASSERT_EQ(figure.panels.size(), report.conditions.size());
    for (const Panel& panel : figure.panels) {
      EXPECT_TRUE(std::isfinite(panel.x.low.value()));
      EXPECT_LT(panel.x.low, panel.x.high);
      EXPECT_GE(panel.x.high, static_cast<double>(limit));
      const auto steps = std::ranges::find(panel.layers, LayerKind::steps, &Layer::kind);
      ASSERT_NE(steps, panel.layers.end());
      EXPECT_EQ(steps->legend, "not yet settled");
      const Table& table = figure.tables[steps->table];
      EXPECT_EQ(std::get<double>(table.rows.front()[0]), panel.x.low);
      EXPECT_EQ(std::get<double>(table.rows.back()[0]), static_cast<double>(limit));
      for (const auto& row : table.rows) EXPECT_EQ(std::get<double>(row[1]), 1.0);
    }
    EXPECT_THAT(figure.caption, HasSubstr("No realisation settled before the end of its observation."));
    const std::string script = script_text(figure, screen_look());
    EXPECT_THAT(script, Not(HasSubstr("inf")));
    EXPECT_THAT(script, Not(HasSubstr("nothing to show")));
  }
}

}  // namespace
