// Figures and table of the peaks: the numbers of the report, and nothing where there is none.

#include "analysis/run_figures.hpp"

#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/output/run_tables.hpp"

namespace {

using namespace rocking;
using namespace rocking::analysis;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<stats::QuantileEstimate> levels(double median) {
  return {{.level = 0.05, .value = 0.5 * median, .low = {}, .high = median},
          {.level = 0.5, .value = median, .low = 0.5 * median, .high = 1.5 * median},
          {.level = 0.95, .value = {}, .low = median, .high = {}}};
}

/// Amplitudes 1, 2, 3; at 3 nothing is known.
Report made() {
  Report report;
  report.input.experiment = {{"title", "made up"}};
  report.swept = {"/excitation/amplitude"};
  for (const double amplitude : {1.0, 2.0, 3.0}) {
    ReportedCondition& condition = report.conditions.emplace_back();
    condition.asked.parameters = {{.pointer = "/excitation/amplitude", .value = amplitude}};
    condition.result.realisations = 30;
    if (amplitude == 3.0) continue;
    condition.result.peaks.tilt = {.realisations = 30, .beyond = 2, .levels = levels(0.25 * amplitude)};
    condition.result.peaks.slip = {.over_half_diagonal = {.realisations = 30, .beyond = 2, .levels = levels(amplitude)},
                                   .metres = levels(8.0 * amplitude)};
  }
  return report;
}

TEST(QuantileFigures, ShowTheNumbersOfTheReport) {
  const auto figures = quantile_figures(made());
  ASSERT_EQ(figures.size(), 2U) << "no final slip";
  EXPECT_EQ(figures[0].name, "peak_tilt");
  const Table& table = figures[0].tables.at(0);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.columns.at(3).name, "median");
  EXPECT_EQ(table.rows[1].size(), table.columns.size());
  EXPECT_EQ(std::get<double>(table.rows[1][0]), 2.0);
  EXPECT_EQ(std::get<double>(table.rows[1][2]), 2.0) << "beyond";
  EXPECT_EQ(std::get<double>(table.rows[1][3]), 0.5);
  EXPECT_EQ(std::get<double>(table.rows[1][4]), 0.25);
  EXPECT_EQ(table.columns.at(9).name, "q95");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[1][9])) << "above every value";
  const Table& ribbon = figures[0].tables.at(1);
  EXPECT_EQ(std::get<double>(ribbon.rows[1][1]), 0.25);
  EXPECT_EQ(figures[1].name, "peak_slip");
  EXPECT_EQ(std::get<double>(figures[1].tables.at(0).rows[1][3]), 16.0) << "in metres";
  EXPECT_EQ(figures[1].panels.at(0).y.unit, "m");
}

// A ribbon with one end would be filled down to the axis.
TEST(QuantileFigures, DrawNoRibbonWhereAnIntervalIsOpen) {
  Report report = made();
  report.conditions[1].result.peaks.tilt.levels[1].high.reset();
  const Table ribbon = quantile_figures(report).at(0).tables.at(1);
  EXPECT_TRUE(ribbon.only_drawn);
  EXPECT_TRUE(std::holds_alternative<double>(ribbon.rows[0][1]));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(ribbon.rows[1][1]));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(ribbon.rows[1][2]));
}

TEST(QuantileFigures, AreNoneWithoutQuantiles) {
  Report report = made();
  for (ReportedCondition& condition : report.conditions) condition.result.peaks = {};
  EXPECT_THAT(quantile_figures(report), IsEmpty());
}

TEST(QuantilesCsv, HasALineForEachLevelAndUnit) {
  const std::string csv = table_files(made(), {"csv"}).at("quantiles.csv");
  EXPECT_THAT(csv, HasSubstr("/excitation/amplitude,n,quantity,unit,of,beyond,level,value,low,high\n"));
  EXPECT_THAT(csv, HasSubstr("2.0,30,peak_tilt,1,30,2,0.5,0.5,0.25,0.75\n"));
  EXPECT_THAT(csv, HasSubstr("2.0,30,peak_tilt,1,30,2,0.95,,0.5,\n"));
  EXPECT_THAT(csv, HasSubstr("1.0,30,peak_slip,R,30,2,0.5,1,0.5,1.5\n"));
  EXPECT_THAT(csv, HasSubstr("1.0,30,peak_slip,m,30,2,0.5,8,4,12\n"));
  EXPECT_THAT(csv, Not(HasSubstr("3.0,")));
}

}  // namespace
