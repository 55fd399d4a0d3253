#include "analysis/mode_figures.hpp"

#include <algorithm>

#include "analysis/data_file.hpp"
#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_shown = 10;

double number(std::uint64_t count) { return static_cast<double>(count); }

/// The ends of an interval, if there is one.
Cell low_of(const AnyShare& share) { return share.interval ? Cell(share.interval->low) : Cell(); }
Cell high_of(const AnyShare& share) { return share.interval ? Cell(share.interval->high) : Cell(); }

std::string table_name(const Slice& slice) { return slice.name.empty() ? "all conditions" : slice.name; }

/// Parts common to all figures of a run.
Figure figure_of(const Report& report, const SweepView& view, std::string name) {
  Figure figure;
  figure.name = std::move(name);
  figure.subtitle = report.title();
  for (const Slice& slice : view.slices) {
    figure.panels.push_back({.title = slice.name,
                             .x = slice.axis,
                             .y = {.quantity = "probability", .symbol = "P", .unit = "", .low = 0.0, .high = 1.0},
                             .layers = {}});
  }
  return figure;
}

void set_range(const SweepView& view, const std::vector<SpanAround>& spans, Panel& panel) {
  panel.x.low = spans.front().low;
  panel.x.high = spans.back().high;
  if (!view.axis.ticks.empty()) panel.x.ticks = view.axis.ticks;
}

/// Words of a caption of a run with `until_classified`.
std::string in_the_end(const Report& report) { return report.has_settling() ? " in the end" : ""; }

std::vector<double> places_of(const SweepView& view, const Slice& slice) {
  std::vector<double> places;
  for (const std::size_t condition : slice.conditions) places.push_back(view.x[condition]);
  return places;
}

// Columns: x, x_low, x_high, n, then from and to of each mode, then of the others.
Table band_table(const Report& report, const SweepView& view, const Slice& slice) {
  const auto modes = shown_modes(report);
  Table table{.name = table_name(slice),
              .columns = {view.column,
                          {view.column.name + "_from", "start of its interval"},
                          {view.column.name + "_to", "end of its interval"},
                          {"n", "realisations"}},
              .rows = {}};
  for (const ResponseMode& mode : modes) {
    table.columns.push_back({to_string(mode) + "_from", "lower edge of the band of " + to_string(mode)});
    table.columns.push_back({to_string(mode) + "_to", "its upper edge; their difference is the estimated probability"});
  }
  table.columns.push_back({"others_from", "lower edge of the band of all other modes"});
  table.columns.push_back({"others_to", "its upper edge: 1"});
  const auto spans = spans_around(places_of(view, slice));
  for (std::size_t i = 0; i < slice.conditions.size(); ++i) {
    const ReportedCondition& condition = report.conditions[slice.conditions[i]];
    const double n = number(condition.result.realisations);
    std::vector<Cell> row{view.x[slice.conditions[i]], spans[i].low, spans[i].high, n};
    std::uint64_t below = 0;
    for (const ResponseMode& mode : modes) {
      row.emplace_back(number(below) / n);
      below += share_of(condition, mode).count;
      row.emplace_back(number(below) / n);
    }
    row.emplace_back(number(below) / n);
    row.emplace_back(1.0);
    table.rows.push_back(std::move(row));
  }
  return table;
}

// Columns: x, n, then count, estimate, low, high of each mode.
Table probability_table(const Report& report, const SweepView& view, const Slice& slice) {
  const std::string level = report.level() + " simultaneous interval";
  Table table{.name = table_name(slice), .columns = {view.column, {"n", "realisations"}}, .rows = {}};
  const auto modes = shown_modes(report);
  for (const ResponseMode& mode : modes) {
    const std::string name = to_string(mode);
    table.columns.push_back({name + "_count", "realisations that were " + name});
    table.columns.push_back({name, "estimated probability of " + name});
    table.columns.push_back({name + "_low", "lower end of its " + level});
    table.columns.push_back({name + "_high", "upper end of its " + level});
  }
  for (const std::size_t i : slice.conditions) {
    const ReportedCondition& condition = report.conditions[i];
    std::vector<Cell> row{view.x[i], number(condition.result.realisations)};
    for (const ResponseMode& mode : modes) {
      const AnyShare share = share_of(condition, mode);
      for (const Cell& cell : {Cell(number(share.count)), Cell(share.estimate), low_of(share), high_of(share)}) {
        row.push_back(cell);
      }
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The interval of a mode, also where it does not occur. Columns: x, low, high.
Table ribbon_table(const Table& probabilities, std::size_t first) {
  Table table{.name = "ribbon of " + probabilities.columns[first + 1].name + ": " + probabilities.name,
              .columns = {probabilities.columns[0], probabilities.columns[first + 2], probabilities.columns[first + 3]},
              .rows = {},
              .only_drawn = true};
  for (const auto& row : probabilities.rows) table.rows.push_back({row[0], row[first + 2], row[first + 3]});
  return table;
}

/// A probability along a line, with its interval.
void add_line(const ResponseMode& mode, std::size_t table, std::size_t first, Figure& figure) {
  Panel& panel = figure.panels[table];
  Style ribbon = style_of(mode);
  ribbon.hatch = 0;
  ribbon.opacity = 0.22;
  if (mode.kind == section::ResponseKind::unresolved) ribbon.colour = "#a0a0a0";
  figure.tables.push_back(ribbon_table(figure.tables[table], first));
  panel.layers.insert(
      panel.layers.begin(),
      {.kind = LayerKind::ribbon, .table = figure.tables.size() - 1, .columns = {0, 1, 2}, .style = ribbon});
  Style line = style_of(mode);
  if (mode.kind == section::ResponseKind::unresolved) line.colour = "#707070";
  panel.layers.push_back(
      {.kind = LayerKind::line, .table = table, .columns = {0, first + 1}, .style = line, .legend = to_string(mode)});
}

/// Rows of one condition for bars: one for each mode.
Table bar_table(const Report& report, const ReportedCondition& condition, const std::string& name) {
  const std::string level = report.level() + " simultaneous interval";
  Table table{.name = name,
              .columns = {{"place", "position of the middle of the bar"},
                          {"from", "its left edge"},
                          {"to", "its right edge"},
                          {"zero", "its bottom"},
                          {"estimate", "estimated probability"},
                          {"low", "lower end of its " + level},
                          {"high", "upper end of its " + level},
                          {"count", "realisations"},
                          {"n", "number of realisations"},
                          {"mode", "response mode"}},
              .rows = {}};
  double place = 0.0;
  for (const ResponseMode& mode : shown_modes(report)) {
    const AnyShare share = share_of(condition, mode);
    table.rows.push_back({place, place - 0.35, place + 0.35, 0.0, share.estimate, low_of(share), high_of(share),
                          number(share.count), number(condition.result.realisations), to_string(mode)});
    place += 1.0;
  }
  return table;
}

Panel bar_panel(const Report& report, std::size_t table, const std::string& title) {
  Panel panel{.title = title,
              .x = {.quantity = "response mode", .symbol = "", .unit = ""},
              .y = {.quantity = "probability", .symbol = "P", .unit = "", .low = 0.0, .high = 1.0},
              .layers = {}};
  const auto modes = shown_modes(report);
  panel.x.low = -0.6;
  panel.x.high = static_cast<double>(modes.size()) - 0.4;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    panel.x.ticks.push_back({.place = static_cast<double>(m), .text = to_string(modes[m])});
  }
  panel.layers.push_back(
      {.kind = LayerKind::error_bars, .table = table, .columns = {0, 4, 5, 6}, .style = {.size = 0.5}});
  return panel;
}

}  // namespace

std::vector<ResponseMode> shown_modes(const Report& report) { return modes_to_show(report.occurring(), most_shown); }

std::string realisations_in_words(const Report& report) {
  std::uint64_t least = report.conditions.front().result.realisations;
  std::uint64_t most = least;
  for (const ReportedCondition& condition : report.conditions) {
    least = std::min(least, condition.result.realisations);
    most = std::max(most, condition.result.realisations);
  }
  const std::string range =
      least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
  return range + (most == 1 ? " realisation" : " realisations") + (report.conditions.size() > 1 ? " each" : "");
}

Figure mode_bands(const Report& report) {
  const SweepView view = view_of(report);
  Figure figure = figure_of(report, view, "mode_bands");
  figure.title = "Probability of each response mode";
  const auto modes = shown_modes(report);
  const bool with_others = report.occurring().size() > modes.size();
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(band_table(report, view, view.slices[i]));
    Panel& panel = figure.panels[i];
    set_range(view, spans_around(places_of(view, view.slices[i])), panel);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      panel.layers.push_back({.kind = LayerKind::boxes,
                              .table = i,
                              .columns = {1, 2, 4 + 2 * m, 5 + 2 * m},
                              .style = style_of(modes[m]),
                              .legend = to_string(modes[m])});
    }
    if (!with_others) continue;
    const std::size_t first = 4 + 2 * modes.size();
    panel.layers.push_back({.kind = LayerKind::boxes,
                            .table = i,
                            .columns = {1, 2, first, first + 1},
                            .style = style_of_others(),
                            .legend = "others"});
  }
  figure.caption = "Estimated probability of each response mode" + in_the_end(report) + ", stacked to 1; " +
                   realisations_in_words(report) + ". Each condition extends halfway to its neighbours.";
  return figure;
}

namespace {

/// Adds a bar for each row of the table that was added last, in the style of its mode, behind the other layers of its
/// panel.
void add_bars(const std::vector<ResponseMode>& modes, Figure& figure) {
  const Table rows = figure.tables.back();
  std::vector<Layer> bars;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto& row = rows.rows[m];
    bars.push_back({.kind = LayerKind::boxes,
                    .table = figure.tables.size(),
                    .columns = {0, 1, 2, 3},
                    .style = style_of(modes[m])});
    figure.tables.push_back({.name = "bar of " + to_string(modes[m]) + ": " + rows.name,
                             .columns = {rows.columns.begin() + 1, rows.columns.begin() + 5},
                             .rows = {{row[1], row[2], row[3], row[4]}},
                             .only_drawn = true});
  }
  auto& layers = figure.panels.back().layers;
  layers.insert(layers.begin(), bars.begin(), bars.end());
}

/// A panel for each condition with a bar for each mode.
Figure mode_bars(const Report& report, const SweepView& view) {
  Figure figure;
  figure.name = "mode_probabilities";
  figure.title = "Probability of each response mode, with intervals";
  figure.subtitle = report.title();
  for (const Slice& slice : view.slices) {
    for (const std::size_t i : slice.conditions) {
      const std::string name = name_of_condition(report, report.conditions[i]);
      figure.tables.push_back(bar_table(report, report.conditions[i], name.empty() ? "the only condition" : name));
      figure.panels.push_back(bar_panel(report, figure.tables.size() - 1, name));
      add_bars(shown_modes(report), figure);
    }
  }
  figure.caption = "Estimated probability of each response mode" + in_the_end(report) + " with its " + report.level() +
                   " simultaneous interval for all modes of a condition; " + realisations_in_words(report) + '.';
  return figure;
}

}  // namespace

Figure mode_probabilities(const Report& report) {
  const SweepView view = view_of(report);
  if (!view.is_line) return mode_bars(report, view);
  Figure figure = figure_of(report, view, "mode_probabilities");
  figure.title = "Probability of each response mode, with intervals";
  const auto modes = shown_modes(report);
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(probability_table(report, view, view.slices[i]));
    set_range(view, spans_around(places_of(view, view.slices[i])), figure.panels[i]);
  }
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    for (std::size_t m = 0; m < modes.size(); ++m) add_line(modes[m], i, 2 + 4 * m, figure);
  }
  figure.caption = "Estimated probability of each response mode" + in_the_end(report) +
                   " (markers, joined to guide the eye) with its " + report.level() +
                   " simultaneous interval for all modes of a condition (ribbon, also where a mode did not occur); " +
                   realisations_in_words(report) + '.';
  return figure;
}

}  // namespace rocking::analysis
