#include "analysis/run_figures.hpp"

#include <algorithm>

#include "analysis/figure_scripts.hpp"
#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/parameter_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_shown = 10;
constexpr std::size_t most_panels = 6;  // of bands; further ones are strips of one panel

double number(std::uint64_t count) { return static_cast<double>(count); }

/// The ends of an interval, if there is one.
Cell low_of(const AnyShare& share) { return share.interval ? Cell(share.interval->low) : Cell(); }
Cell high_of(const AnyShare& share) { return share.interval ? Cell(share.interval->high) : Cell(); }

/// Parts common to all figures of a run.
Figure figure_of(const Report& report, const SweepView& view, std::string name) {
  Figure figure{.name = std::move(name), .subtitle = report.title()};
  for (const Slice& slice : view.slices) {
    figure.panels.push_back({.title = slice.name,
                             .x = slice.axis,
                             .y = {.quantity = "probability", .symbol = "P", .low = 0.0, .high = 1.0}});
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

/// Column of a table of bands at which their edges begin.
constexpr std::size_t first_edge = 4;

// Columns: x, x_low, x_high, n, then from and to of each mode, then of the others.
Table band_table(const Report& report, const SweepView& view, const Slice& slice) {
  const auto modes = shown_modes(report);
  Table table{.name = slice.words(),
              .columns = {view.column,
                          {view.column.name + "_from", "start of its interval"},
                          {view.column.name + "_to", "end of its interval"},
                          {"n", "realisations"}}};
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
    Row row{view.x[slice.conditions[i]], spans[i].low, spans[i].high, n};
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

Table probability_table(const Report& report, const SweepView& view, const Slice& slice) {
  Table table{.name = slice.words(), .columns = {view.column, {"n", "realisations"}}};
  const auto modes = shown_modes(report);
  for (const ResponseMode& mode : modes) {
    const std::string name = to_string(mode);
    table.columns.push_back({name + "_count", "realisations that were " + name});
    add_estimate(table, {name, "estimated probability of " + name, report.level() + " simultaneous interval"});
  }
  for (const std::size_t i : slice.conditions) {
    const ReportedCondition& condition = report.conditions[i];
    Row row{view.x[i], number(condition.result.realisations)};
    for (const ResponseMode& mode : modes) {
      const AnyShare share = share_of(condition, mode);
      row.insert(row.end(), {share.count, share.estimate, low_of(share), high_of(share)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// A probability along a line, with its interval, also where it does not occur.
void add_line(const ResponseMode& mode, std::size_t table, const std::string& x, Figure& figure) {
  const std::string name = to_string(mode);
  std::vector<Layer>& layers = figure.panels[table].layers;
  const bool is_unresolved = mode.kind == section::ResponseKind::unresolved;
  Style ribbon = ribbon_of(style_of(mode), 0.22);
  if (is_unresolved) ribbon.colour = "#a0a0a0";
  const Table& whole = figure.tables[table];
  Style line = style_of(mode);
  if (is_unresolved) line.colour = "#707070";
  draw({.kind = LayerKind::line, .table = table, .style = line, .legend = name}, {x, name}, figure, table);
  layers.insert(layers.begin(), {.kind = LayerKind::ribbon,
                                 .table = figure.tables.size(),
                                 .columns = first_columns(LayerKind::ribbon),
                                 .style = ribbon});
  figure.tables.push_back(drawn_part(whole, "ribbon of " + name + ": ", {x, name + "_low", name + "_high"}));
}

/// Of categories: the modes side by side, with their intervals. Of one condition the axis names the modes.
void add_mode_bars(const Report& report, const SweepView& view, std::size_t slice, Figure& figure) {
  const auto modes = shown_modes(report);
  const Table whole = figure.tables[slice];
  Panel& panel = figure.panels[slice];
  if (report.swept.empty()) panel.x = {.quantity = "response mode"};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const std::string name = to_string(modes[m]);
    const CategoryBars bars{m, modes.size(), {name, name + "_low", name + "_high"}, style_of(modes[m]), name, slice};
    add_bars(whole, bars, figure);
    if (report.swept.empty()) panel.x.ticks.push_back({.place = bars.shift(), .text = name});
  }
  set_range(view, spans_around(places_of(view, view.slices[slice])), panel);
}

/// The bands of all slices in one panel: each slice has a strip of this height, one above the other.
constexpr double strip = 0.9;
constexpr double gap_below = 0.5 * (1.0 - strip);
/// Ten times the height of a panel.
constexpr std::size_t most_strips = 200;

Table strip_table(const std::vector<Table>& bands) {
  Table strips{.name = "strips of all combinations", .columns = bands.front().columns, .only_drawn = true};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (Row row : bands[i].rows) {
      for (std::size_t c = first_edge; c < row.size(); ++c) {
        row[c] = static_cast<double>(i) + gap_below + strip * std::get<double>(row[c]);
      }
      strips.rows.push_back(std::move(row));
    }
  }
  return strips;
}

/// The values of the other parameters beside each strip.
Axis strip_axis(const Report& report, const SweepView& view) {
  Axis axis;
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    axis.ticks.push_back({.place = static_cast<double>(i) + 0.5, .text = ""});
  }
  for (std::size_t entry = 0; entry < report.swept.size(); ++entry) {
    if (entry == view.entry) continue;
    const bool is_first = axis.quantity.empty();
    const Axis own = axis_of_parameter(report.swept[entry], shakings_of(report));
    axis.quantity += is_first ? own.quantity : ", " + own.quantity;
    axis.symbol = is_first ? own.symbol : "";
    axis.unit = is_first ? own.unit : "";
    for (std::size_t i = 0; i < view.slices.size(); ++i) {
      const std::string value =
          short_value(report.conditions[view.slices[i].conditions.front()].asked.parameters[entry]);
      axis.ticks[i].text += is_first ? value : ", " + value;
    }
  }
  axis.low = 0.0;
  axis.high = static_cast<double>(view.slices.size());
  return axis;
}

/// Draws the bands, which are the tables of the figure, as strips.
void set_in_strips(const Report& report, const SweepView& view, Figure& figure) {
  constexpr double height_of_a_strip = 0.05;
  figure.panels.resize(1);
  Panel& panel = figure.panels.front();
  panel.title.clear();
  panel.x = view.axis;
  panel.y = strip_axis(report, view);
  panel.strip = strip;
  panel.height = std::max(1.0, height_of_a_strip * static_cast<double>(view.slices.size()));
  figure.tables.push_back(strip_table(figure.tables));
}

/// Adds the bands of a table to the panel.
void add_bands(const Report& report, std::size_t table, Panel& panel) {
  const auto modes = shown_modes(report);
  const auto add = [&](std::size_t place, const Style& style, const std::string& legend) {
    const std::size_t first = first_edge + 2 * place;
    panel.layers.push_back({LayerKind::boxes, table, {1, 2, first, first + 1}, style, legend});
  };
  for (std::size_t m = 0; m < modes.size(); ++m) add(m, style_of(modes[m]), to_string(modes[m]));
  if (report.occurring().size() > modes.size()) add(modes.size(), style_of_others(), "others");
}

}  // namespace

std::vector<ResponseMode> shown_modes(const Report& report) { return modes_to_show(report.occurring(), most_shown); }

std::string realisations_in_words(const Report& report) {
  NumberRange range;
  for (const ReportedCondition& condition : report.conditions) {
    range.add(static_cast<double>(condition.result.realisations));
  }
  return range_in_words(range, 17) + (range.largest == 1.0 ? " realisation" : " realisations") +
         (report.conditions.size() > 1 ? " each" : "");
}

Figure mode_bands(const Report& report) {
  const SweepView view = view_of(report, most_strips);
  Figure figure = figure_of(report, view, "mode_bands");
  figure.title = "Probability of each response mode";
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(band_table(report, view, view.slices[i]));
    set_range(view, spans_around(places_of(view, view.slices[i])), figure.panels[i]);
  }
  const bool in_strips = view.slices.size() > most_panels;
  if (in_strips) set_in_strips(report, view, figure);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    add_bands(report, in_strips ? view.slices.size() : i, figure.panels[i]);
  }
  figure.caption = "Estimated probability of each response mode" + in_the_end(report) + ", stacked to 1; " +
                   realisations_in_words(report) + ". Each condition extends halfway to its neighbours." +
                   (in_strips ? " One strip for each combination of the other parameters." : "") +
                   slices_left_out(view);
  return figure;
}

Figure mode_probabilities(const Report& report) {
  const SweepView view = view_of(report);
  Figure figure = figure_of(report, view, "mode_probabilities");
  figure.title = "Probability of each response mode, with intervals";
  const auto modes = shown_modes(report);
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(probability_table(report, view, view.slices[i]));
    set_range(view, spans_around(places_of(view, view.slices[i])), figure.panels[i]);
  }
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    if (!view.is_line) add_mode_bars(report, view, i, figure);
    if (!view.is_line) continue;
    for (const ResponseMode& mode : modes) add_line(mode, i, view.column.name, figure);
  }
  const std::string joined = view.is_line ? " (markers, joined to guide the eye)" : " (markers)";
  const std::string interval = view.is_line ? "ribbon, also where a mode did not occur" : "bars with caps";
  figure.caption = "Estimated probability of each response mode" + in_the_end(report) + joined + " with its " +
                   report.level() + " simultaneous interval for all modes of a condition (" + interval + "); " +
                   realisations_in_words(report) + '.' + slices_left_out(view);
  return figure;
}

}  // namespace rocking::analysis
