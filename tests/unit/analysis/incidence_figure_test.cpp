// The figure of settling where nothing has settled.

#include "analysis/incidence_figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "analysis/gnuplot_script.hpp"
#include "analysis/run_report.hpp"
#include "support/sample_report.hpp"

namespace {

using namespace rocking::analysis;
using rocking::support::sample_report;
using ::testing::HasSubstr;
using ::testing::Not;

/// A run with `until_classified` of which no realisation settled; `limit` in excitation periods.
RunReport unsettled(std::int64_t limit) {
  RunReport report = run_report_of(sample_report());
  report.experiment["horizon"]["until_classified"] = {{"at_most_periods", limit}, {"held_windows", 2}};
  for (ConditionReport& condition : report.conditions) {
    condition.modes = {{{}, {.count = 30, .estimate = 1.0, .interval = {.low = 0.9, .high = 1.0}}}};
    IncidenceReport& incidence = condition.incidence.emplace();
    incidence.any_mode.emplace();
    incidence.settling.realisations = 30;
    incidence.settling.censored = 30;
    incidence.settling.unresolved_at_horizon = 30;
  }
  return report;
}

TEST(IncidenceFigure, DrawsWhatNeverSettledUpToTheEndOfItsObservation) {
  for (const std::int64_t limit : {625, 1000, 200000}) {
    const RunReport report = unsettled(limit);
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
