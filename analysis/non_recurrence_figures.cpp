#include "analysis/run_figures.hpp"

#include <algorithm>
#include <array>

#include "analysis/data_file.hpp"
#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"

namespace rocking::analysis {
namespace {

Cell cell_of(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

bool has_differences(const Report& report) {
  return std::any_of(report.conditions.begin(), report.conditions.end(),
                     [](const ReportedCondition& condition) { return condition.result.non_recurrence.has_value(); });
}

std::string name_of(const Slice& slice) { return slice.name.empty() ? "all conditions" : slice.name; }

Table difference_table(const Report& report, const SweepView& view, const Slice& slice) {
  const std::string level = report.level() + " interval";
  Table table{.name = name_of(slice),
              .columns = {view.column,
                          {"n", "realisations"},
                          {"differ", "probability that two runs differ in response mode"},
                          {"low", "lower end of its " + level},
                          {"high", "upper end of its " + level},
                          {"entropy", "entropy of the response modes [nat]"}},
              .rows = {}};
  for (const std::size_t i : slice.conditions) {
    const ReportedCondition& condition = report.conditions[i];
    if (!condition.result.non_recurrence) continue;
    const NonRecurrence& found = *condition.result.non_recurrence;
    table.rows.push_back({view.x[i], static_cast<double>(condition.result.realisations), found.differ,
                          found.differ_interval.low, found.differ_interval.high, found.entropy});
  }
  return table;
}

Table divergence_table(const Report& report, const SweepView& view, const Slice& slice) {
  Table table{.name = name_of(slice),
              .columns = {view.column,
                          {"pairs", "pairs of runs"},
                          {"diverged", "of these diverged before the horizon"},
                          {"median", "median of the divergence time [periods]"},
                          {"lower", "lower quartile [periods]"},
                          {"upper", "upper quartile [periods]"},
                          {"upper_drawn", "upper quartile as drawn, cut at the horizon [periods]"}},
              .rows = {}};
  const auto periods = report.periods();
  const Cell end = periods ? Cell(static_cast<double>(*periods)) : Cell();
  for (const std::size_t i : slice.conditions) {
    if (!report.conditions[i].result.non_recurrence) continue;
    const DivergenceTimes& divergence = report.conditions[i].result.non_recurrence->friction;
    if (divergence.pairs == 0) continue;
    const Cell drawn = !divergence.lower_quartile  ? Cell()
                       : divergence.upper_quartile ? Cell(*divergence.upper_quartile)
                                                   : end;
    table.rows.push_back({view.x[i], static_cast<double>(divergence.pairs), static_cast<double>(divergence.diverged),
                          cell_of(divergence.median), cell_of(divergence.lower_quartile),
                          cell_of(divergence.upper_quartile), drawn});
  }
  return table;
}

/// Adds a ribbon and its curve, or bars of categories, for the table that was added last.
void add_curve(const SweepView& view, std::size_t number, const std::array<std::size_t, 3>& columns, Figure& figure) {
  const Slice& slice = view.slices[number];
  if (!view.is_line) {
    const Table whole = figure.tables.back();
    return add_bars(whole, {number, view.slices.size(), columns, style_of_curve(number), name_of(slice)}, figure);
  }
  Panel& panel = figure.panels.front();
  const std::size_t table = figure.tables.size() - 1;
  Style ribbon = style_of_curve(number);
  ribbon.hatch = 0;
  ribbon.opacity = 0.2;
  panel.layers.push_back(
      {.kind = LayerKind::ribbon, .table = table, .columns = {0, columns[1], columns[2]}, .style = ribbon});
  panel.layers.push_back({.kind = LayerKind::line,
                          .table = table,
                          .columns = {0, columns[0]},
                          .style = style_of_curve(number),
                          .legend = name_of(slice)});
}

Figure empty_figure(const Report& report, const SweepView& view) {
  Figure figure;
  figure.subtitle = report.title();
  Panel panel{.title = "", .x = view.axis, .y = {}, .layers = {}};
  set_range(view, panel);
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::optional<Figure> non_recurrence(const Report& report) {
  if (!has_differences(report)) return std::nullopt;
  const SweepView view = view_of(report);
  Figure figure = empty_figure(report, view);
  figure.name = "non_recurrence";
  figure.title = "Probability that two equal runs have different responses";
  figure.panels.front().y = {
      .quantity = "probability that two runs differ", .symbol = "", .unit = "", .low = 0.0, .high = 1.0};
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(difference_table(report, view, view.slices[i]));
    add_curve(view, i, {2, 3, 4}, figure);
  }
  figure.caption =
      "Probability that two runs of one condition, with independent random numbers, differ in response mode, with "
      "its " +
      report.level() + " interval; " + realisations_in_words(report) + '.' + slices_left_out(view);
  return figure;
}

std::optional<Figure> divergence_quartiles(const Report& report) {
  if (!has_differences(report)) return std::nullopt;
  const SweepView view = view_of(report);
  Figure figure = empty_figure(report, view);
  figure.name = "divergence_quartiles";
  figure.title = "Divergence time of two equal runs";
  figure.panels.front().y = {
      .quantity = "divergence time", .symbol = "", .unit = "excitation periods", .low = 1.0, .logarithmic = true};
  bool any = false;
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(divergence_table(report, view, view.slices[i]));
    const auto& rows = figure.tables.back().rows;
    any = any ||
          std::any_of(rows.begin(), rows.end(), [](const auto& row) { return std::holds_alternative<double>(row[4]); });
    add_curve(view, i, {3, 4, 6}, figure);
  }
  if (!any) return std::nullopt;
  figure.caption =
      "Periods until two runs of one condition, with independent random numbers, are more than 0.01 apart in (Θ, Θ′): "
      "median "
      "(markers) and quartiles over pairs (" +
      std::string(view.is_line ? "ribbon" : "bars") + ", cut at the horizon). Where no marker or no " +
      (view.is_line ? "ribbon is" : "bars are") +
      " shown, more than half, or three quarters, of the pairs had not diverged by the horizon." +
      slices_left_out(view);
  return figure;
}

}  // namespace rocking::analysis
