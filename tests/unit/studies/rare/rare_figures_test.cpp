// The committor and the paths of a rare event as figures.

#include "rocking/studies/rare/study.hpp"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace {

using rocking::RareReport;
using rocking::ReportedRare;
using rocking::analysis::Cell;
using rocking::analysis::Figure;
using rocking::analysis::Layer;
using rocking::analysis::LayerKind;
using rocking::analysis::rare_figures;
using rocking::analysis::Table;

/// Small where Theta' > 0, and 1 in one cell of the middle row.
ReportedRare condition_with_map() {
  ReportedRare condition;
  condition.estimate.probability = 2e-5;
  condition.estimate.committor = {.tilt = 1.0, .tilt_rate = 0.5, .rows = {{0, 0, 0}, {0, 1, 0.7}, {2e-5, 3e-3, 4e-3}}};
  rocking::rare::Path path;
  path.samples_per_period = 2;
  path.tilts = {{0.0, 0.4}, {0.9, -1.6}, {-5.0}};
  path.strobe = {{0.2, 0.1}, {0.9, 0.7}};
  condition.estimate.paths = {path};
  return condition;
}

double cell_number(const Cell& cell) { return std::get<double>(cell); }

const Table& table_with(const Figure& figure, const std::string& legend) {
  const auto& layers = figure.panels.front().layers;
  return figure.tables[std::ranges::find(layers, legend, &Layer::legend)->table];
}

TEST(RareFigures, DrawTheCommittorInClasses) {
  const std::vector<Figure> figures =
      rare_figures({.input = {}, .question = {}, .conditions = {condition_with_map()}, .suites = {}});
  ASSERT_EQ(figures.size(), 2U);
  const Figure& figure = figures.front();
  EXPECT_EQ(figure.name, "rare_committor");
  const Table& likely = table_with(figure, "probability 0.5 to 1");
  ASSERT_EQ(likely.rows.size(), 1U) << "neighbours in a row are one box";
  EXPECT_DOUBLE_EQ(cell_number(likely.rows[0][0]), -0.5);
  EXPECT_DOUBLE_EQ(cell_number(likely.rows[0][1]), 1.0);
  EXPECT_DOUBLE_EQ(cell_number(likely.rows[0][2]), -0.25);
  EXPECT_DOUBLE_EQ(cell_number(likely.rows[0][3]), 0.25);
  const Table& small = table_with(figure, "probability 1e-3 to 0.01");
  ASSERT_EQ(small.rows.size(), 1U);
  EXPECT_DOUBLE_EQ(cell_number(small.rows[0][2]), 0.25);
  EXPECT_DOUBLE_EQ(cell_number(small.rows[0][3]), 0.5);
  EXPECT_EQ(table_with(figure, "strobe points of paths to the event").rows.size(), 1U) << "the other is beyond the map";
}

TEST(RareFigures, DrawThePathsUntilTheyFall) {
  const Figure figure =
      rare_figures({.input = {}, .question = {}, .conditions = {condition_with_map()}, .suites = {}}).back();
  EXPECT_EQ(figure.name, "rare_paths");
  const Table& path = table_with(figure, "path 1");
  ASSERT_EQ(path.rows.size(), 4U);
  EXPECT_DOUBLE_EQ(cell_number(path.rows[3][0]), 1.5);
  EXPECT_DOUBLE_EQ(cell_number(path.rows[3][1]), -1.6);
}

TEST(RareFigures, HaveAtMostSixPanelsAndNoneWithoutAnything) {
  EXPECT_TRUE(rare_figures({.input = {}, .question = {}, .conditions = {ReportedRare{}}, .suites = {}}).empty());
  const RareReport many{.input = {}, .question = {}, .conditions = std::vector(9, condition_with_map()), .suites = {}};
  const std::vector<Figure> figures = rare_figures(many);
  EXPECT_EQ(figures.size(), 2U);
  for (const Figure& figure : figures) EXPECT_EQ(figure.panels.size(), 6U);
}

}  // namespace
