// Values with intervals at categories, between which no line means anything.

#include <algorithm>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/run_figures.hpp"
#include "rocking/output/report.hpp"
#include "support/sample_report.hpp"

namespace {

using namespace rocking;
using namespace rocking::analysis;
using rocking::Json;
using rocking::support::sample_report;
using ::testing::HasSubstr;
using ::testing::Not;

const Layer* layer_in(const Figure& figure, LayerKind kind) {
  for (const Layer& layer : figure.panels.front().layers) {
    if (layer.kind == kind) return &layer;
  }
  return nullptr;
}

/// Two frictions and nothing else: categories.
Report categories() {
  Json json = sample_report();
  Json& experiment = json["input"]["experiment"];
  experiment["sweep"].erase(1);
  Json& conditions = json["result"]["conditions"];
  const Json all = conditions;
  conditions = Json::array();
  for (const std::size_t i : {1U, 4U}) {
    conditions.push_back(all[i]);
    conditions.back()["parameters"].erase("/excitation/amplitude");
  }
  Report report = report_in(std::move(json));
  for (ReportedCondition& condition : report.conditions) {
    condition.result.peaks.tilt = {.realisations = 30,
                                   .beyond = 0,
                                   .levels = {{.level = 0.05, .value = 0.1, .low = 0.05, .high = 0.2},
                                              {.level = 0.5, .value = 0.3, .low = 0.2, .high = 0.4},
                                              {.level = 0.95, .value = 0.6, .low = 0.5, .high = {}}}};
  }
  return report;
}

TEST(Categories, HaveBarsAndNeitherRibbonsNorLines) {
  const Report report = categories();
  std::vector<Figure> figures = quantile_figures(report);
  figures.push_back(non_recurrence(report).value());
  figures.push_back(divergence_quartiles(report).value());
  ASSERT_EQ(figures.size(), 3U);
  for (const Figure& figure : figures) {
    for (const Layer& layer : figure.panels.front().layers) {
      EXPECT_TRUE(layer.kind == LayerKind::error_bars || layer.kind == LayerKind::points) << figure.name;
    }
    const Layer* bars = layer_in(figure, LayerKind::error_bars);
    ASSERT_NE(bars, nullptr) << figure.name;
    const Table& table = figure.tables[bars->table];
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(std::get<double>(table.rows[0][0]), 0.0);
    EXPECT_EQ(std::get<double>(table.rows[1][0]), 1.0);
    EXPECT_THAT(figure.caption, Not(HasSubstr("ribbon")));
  }
  const Figure differing = non_recurrence(report).value();
  const Table& table = differing.tables[layer_in(differing, LayerKind::error_bars)->table];
  EXPECT_EQ(std::get<double>(table.rows[1][1]), report.conditions[1].result.non_recurrence->differ);
  EXPECT_EQ(std::get<double>(table.rows[1][2]), report.conditions[1].result.non_recurrence->differ_interval.low);
  EXPECT_EQ(std::get<double>(table.rows[1][3]), report.conditions[1].result.non_recurrence->differ_interval.high);
}

TEST(Categories, OfSeveralSlicesStandSideBySide) {
  Report report = categories();
  report.swept.push_back("/formulation");
  const auto first = report.conditions;
  for (ReportedCondition& condition : report.conditions)
    condition.asked.parameters.push_back({"/formulation", "consistent"});
  for (ReportedCondition condition : first) {
    condition.asked.parameters.push_back({"/formulation", "as-printed"});
    report.conditions.push_back(condition);
  }
  const Figure figure = non_recurrence(report).value();
  std::vector<double> places;
  for (const Layer& layer : figure.panels.front().layers) {
    if (layer.kind != LayerKind::error_bars) continue;
    for (const auto& row : figure.tables[layer.table].rows) places.push_back(std::get<double>(row[0]));
  }
  std::ranges::sort(places);
  ASSERT_EQ(places.size(), 4U);
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GT(places[i] - places[i - 1], 0.2);
}

}  // namespace
