#include "rocking/studies/infer/study.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// The same axis with places 0, 1, ... of these names.
Axis with_names(Axis axis, const std::vector<std::string>& names) {
  axis.low = -0.5;
  axis.high = static_cast<double>(names.size()) - 0.5;
  for (const std::string& name : names) axis.ticks.push_back({static_cast<double>(axis.ticks.size()), name});
  return axis;
}

Axis axis_of_categories(const std::string& quantity) { return {.quantity = quantity}; }

/// A row for each group: its place, the number of tests, those that showed it, their share with its interval, and the
/// predicted share.
Table counts_table(const InferReport& report, const ReportedTests& tests) {
  const std::string level = level_text(report.confidence) + " % interval";
  Table table{.name = values_in_words(tests.parameters),
              .columns = {{"group", "group of response modes"},
                          {"tests", "tests"},
                          {"count", "of these with this group"},
                          {"share", "their share", "exact " + level},
                          {"low", "lower end of its exact " + level},
                          {"high", "upper end of its exact " + level},
                          {"predicted", "share at the estimate"}}};
  const std::uint64_t all = std::accumulate(tests.counts.begin(), tests.counts.end(), std::uint64_t{0});
  for (std::size_t g = 0; g < tests.counts.size(); ++g) {
    const auto count = static_cast<double>(tests.counts[g]);
    table.rows.push_back({g, all, count, count / static_cast<double>(all), tests.intervals[g].low,
                          tests.intervals[g].high, tests.predicted[g]});
  }
  return table;
}

/// Boxes from 0 to the predicted shares.
Table predicted_table(const ReportedTests& tests) {
  constexpr double half_width = 0.35;
  Table table{
      .name = "predicted, " + values_in_words(tests.parameters),
      .columns = {{"from", "group, from"}, {"to", "group, to"}, {"zero", "0"}, {"predicted", "predicted share"}}};
  for (std::size_t g = 0; g < tests.predicted.size(); ++g) {
    const auto place = static_cast<double>(g);
    table.rows.push_back({place - half_width, place + half_width, 0.0, tests.predicted[g]});
  }
  return table;
}

void add_condition(const InferReport& report, const ReportedTests& tests, Figure& figure) {
  Table counts = counts_table(report, tests);
  figure.panels.push_back({.title = counts.name,
                           .x = with_names(axis_of_categories("group of response modes"), report.groups),
                           .y = {.quantity = "share of the tests", .low = 0.0, .high = 1.0}});
  add_drawn(predicted_table(tests),
            {.kind = LayerKind::boxes, .style = {.colour = "#c6dbef"}, .legend = "predicted by the estimate"}, figure);
  figure.tables.push_back(std::move(counts));
  const Table counted = figure.tables.back();
  Style style = style_of_curve(0);
  style.colour = "#08306b";
  add_bars(counted, {0, 1, {"share", "low", "high"}, style, "counted", figure.panels.size() - 1}, figure);
}

/// Of candidates that differ in one parameter only its values are named.
Axis axis_of_candidates(const std::vector<ReportedCandidate>& candidates) {
  const std::vector<Parameter>& first = candidates.front().parameters;
  std::vector<std::string> names;
  for (const ReportedCandidate& candidate : candidates) {
    names.push_back(first.size() == 1 ? short_value(candidate.parameters.front())
                                      : values_in_words(candidate.parameters));
  }
  return with_names(
      first.size() == 1 ? axis_of_parameter(first.front().pointer) : axis_of_categories("candidate condition"), names);
}

/// A row for each candidate: its place, then the expected sizes over the present ones.
Table candidates_table(const InferReport& report) {
  Table table{.name = "", .columns = {{"candidate", "candidate condition"}, {"region", "joint region"}}};
  for (std::size_t k = 0; k < report.unknowns.size(); ++k) {
    table.columns.push_back(
        {"deviation_" + std::to_string(k + 1), axis_of_parameter(report.unknowns[k].parameter).quantity});
  }
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    const ReportedCandidate& candidate = report.candidates[i];
    Row& row = table.rows.emplace_back(Row{i, *candidate.region});
    for (const double deviation : candidate.deviations) row.emplace_back(deviation);
  }
  return table;
}

/// Markers of a column, beside those of the other columns.
void add_markers(const Table& table, std::size_t column, Figure& figure) {
  const std::string& legend = table.columns[column].meaning;
  const CategoryBars place{.number = column - 1,
                           .of = table.columns.size() - 1,
                           .columns = {},
                           .style = style_of_curve(column - 1),
                           .legend = legend};
  Table drawn{.name = "drawn: " + legend, .columns = {table.columns[0], table.columns[column]}};
  for (const auto& row : table.rows) drawn.rows.push_back({std::get<double>(row[0]) + place.shift(), row[column]});
  add_drawn(std::move(drawn), {.kind = LayerKind::points, .style = place.style, .legend = place.legend}, figure);
}

}  // namespace

Figure fit_figure(const InferReport& report) {
  Figure figure{
      .name = "infer_fit", .title = "Does the estimate explain the counted tests?", .subtitle = report.input.title()};
  for (std::size_t i = 0; i < std::min(report.tests.size(), most_slices); ++i) {
    add_condition(report, report.tests[i], figure);
  }
  figure.description = "Fit: " + fit_in_words(report) + '.';
  figure.caption =
      "Boxes: share of each group of response modes at the estimate. Markers: counted shares of the tests, with their "
      "exact " +
      level_text(report.confidence) + " % intervals, each for itself. A panel for each tested condition.";
  return figure;
}

std::optional<Figure> candidates_figure(const InferReport& report) {
  if (report.candidates.empty()) return std::nullopt;
  Figure figure{.name = "infer_candidates", .title = "Which test next?", .subtitle = report.input.title()};
  const Table table = candidates_table(report);
  figure.tables.push_back(table);
  double largest = 1.0;
  for (const auto& row : table.rows) {
    for (std::size_t c = 1; c < row.size(); ++c) largest = std::max(largest, std::get<double>(row[c]));
  }
  constexpr double room = 0.05;
  figure.panels.push_back(
      {.x = axis_of_candidates(report.candidates),
       .y = {.quantity = "expected size over the present one", .low = 0.0, .high = largest + room}});
  for (std::size_t c = 1; c < table.columns.size(); ++c) add_markers(table, c, figure);
  const auto best = std::ranges::min_element(report.candidates, {}, [](const auto& each) { return *each.region; });
  figure.description = "Tests at " + values_in_words(best->parameters) +
                       " are expected to tell most: the region would have " + significant(*best->region, 2) +
                       " of its present size.";
  figure.caption = "Expected size after " + counted(report.next_tests, "more test") +
                   " under each candidate condition, over the present one: of the joint region, and of each unknown "
                   "its standard deviation. 1: the tests tell nothing.";
  return figure;
}

}  // namespace rocking::analysis
