#include "analysis/run_figures.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "analysis/figure_scripts.hpp"
#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// A quantity whose quantiles are drawn.
struct Drawn {
  const char* key;                                                    ///< in a report, and of the figure
  std::optional<Quantiles> (*quantiles)(const PeakQuantiles& peaks);  ///< absent: there are none
  const char* title;
  const char* quantity;
  const char* symbol;
  const char* unit;
  bool is_signed;  ///< both outer quantiles are drawn; otherwise the upper one
  const char* meaning;
};

std::optional<Quantiles> metres_of(const std::optional<PeakQuantiles::Slip>& slip) {
  if (!slip) return std::nullopt;
  Quantiles quantiles = slip->over_half_diagonal;
  quantiles.levels = slip->metres;
  return quantiles;
}

constexpr std::array drawn_quantities{
    Drawn{"peak_tilt", [](const PeakQuantiles& peaks) { return std::optional(peaks.tilt); },
          "How far does the block tilt?", "largest tilt", "|Θ|", "", false,
          "Largest |Θ| = |θ|/ψ of a realisation, over ψ of its side"},
    Drawn{"peak_slip", [](const PeakQuantiles& peaks) { return metres_of(peaks.slip); },
          "How far does the block slip at most?", "largest slip", "", "m", false,
          "Largest distance of a realisation's block from its place on the base"},
    Drawn{"final_slip", [](const PeakQuantiles& peaks) { return metres_of(peaks.final_slip); },
          "Where does the block end up?", "slip at the end", "", "m", true,
          "Distance of the block from its place on the base at the horizon, to the right > 0"},
};

constexpr std::array drawn_levels{0.5, 0.05, 0.95};

std::string percent_of(double level) { return significant(100.0 * level, 4); }

/// Of each quantile its value and the ends of its interval.
void add_columns(const Report& report, const std::string& unit, Table& table) {
  for (const double level : drawn_levels) {
    const std::string key = level == 0.5 ? "median" : "q" + percent_of(level);
    const std::string meaning = (level == 0.5 ? "median" : percent_of(level) + " % quantile") + unit;
    add_estimate(table, {key, meaning, report.level() + " interval"}, unit);
  }
}

void add_cells(const Quantiles& quantiles, Row& row) {
  for (const double level : drawn_levels) {
    const stats::QuantileEstimate quantile = quantile_at(quantiles.levels, level);
    row.insert(row.end(), {quantile.value, quantile.low, quantile.high});
  }
}

Table quantile_table(const Report& report, const SweepView& view, const Slice& slice, const Drawn& drawn) {
  const std::string unit = drawn.unit[0] == '\0' ? "" : std::string(" [") + drawn.unit + ']';
  Table table{.name = slice.words(),
              .columns = {view.column, {"n", "realisations"}, {"beyond", "of these overturned"}}};
  add_columns(report, unit, table);
  for (const std::size_t i : slice.conditions) {
    const auto found = drawn.quantiles(report.conditions[i].result.peaks);
    if (!found) continue;
    table.rows.push_back({view.x[i], found->realisations, found->beyond});
    add_cells(*found, table.rows.back());
  }
  return table;
}

/// The ends of the median's interval where both exist: gnuplot would fill a ribbon with one end down to the axis.
Table ribbon_table(const Table& whole) {
  Table table = drawn_part(whole, "", {whole.columns[0].name, "median_low", "median_high"});
  for (auto& row : table.rows) {
    if (!std::holds_alternative<double>(row[1]) || !std::holds_alternative<double>(row[2])) row[1] = row[2] = Cell();
  }
  return table;
}

/// Adds what is drawn of the table that was added last: the median with its interval, and the outer quantiles, of
/// categories with theirs.
void add_quantiles(const SweepView& view, std::size_t number, const Drawn& drawn, Figure& figure) {
  const std::string name = view.slices[number].name.empty() ? "" : view.slices[number].name + ", ";
  const std::string legend = name + (drawn.is_signed ? "5 % and 95 % quantiles" : "95 % quantile");
  const Style style = style_of_curve(number);
  Style outer = style;
  outer.marker = 6;  // a circle: not filled
  if (!view.is_line) {
    const Table whole = figure.tables.back();
    const auto add = [&](const std::string& key, const Style& look, const std::string& words) {
      add_bars(whole, {number, view.slices.size(), {key, key + "_low", key + "_high"}, look, words}, figure);
    };
    add("median", style, name + "median");
    if (drawn.is_signed) add("q5", outer, "");
    return add("q95", outer, legend);
  }
  outer.dash = 2;
  outer.width = 1.0;
  outer.size = 0.4;
  const std::size_t table = figure.tables.size() - 1;
  const auto add = [&](const char* key, const Style& look, const std::string& words) {
    draw({.kind = LayerKind::line, .table = table, .style = look, .legend = words}, {view.column.name, key}, figure);
  };
  figure.tables.push_back(ribbon_table(figure.tables.back()));
  draw({.kind = LayerKind::ribbon, .table = table + 1, .style = ribbon_of(style)}, {}, figure);
  add("median", style, name + "median");
  if (drawn.is_signed) add("q5", outer, "");
  add("q95", outer, legend);
}

/// Whether any quantile is not 0.
bool shows_something(const Report& report, const Drawn& drawn) {
  return std::ranges::any_of(report.conditions, [&](const ReportedCondition& condition) {
    const auto found = drawn.quantiles(condition.result.peaks);
    if (!found) return false;
    const auto is_seen = [](const stats::QuantileEstimate& quantile) { return quantile.value.value_or(0.0) != 0.0; };
    return std::ranges::any_of(found->levels, is_seen);
  });
}

Figure quantile_figure(const Report& report, const Drawn& drawn) {
  const SweepView view = view_of(report);
  Figure figure{.name = drawn.key, .title = drawn.title, .subtitle = report.title()};
  Panel panel{.x = view.axis, .y = {.quantity = drawn.quantity, .symbol = drawn.symbol, .unit = drawn.unit}};
  set_range(view, panel);
  if (!drawn.is_signed) panel.y.low = 0.0;
  figure.panels.push_back(std::move(panel));
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(quantile_table(report, view, view.slices[i], drawn));
    add_quantiles(view, i, drawn, figure);
  }
  figure.caption = std::string(drawn.meaning) + ": median with its " + report.level() + " interval (" +
                   (view.is_line ? "ribbon" : "bars") + "), and the " +
                   (drawn.is_signed ? "5 % and 95 % quantiles" : "95 % quantile") +
                   (view.is_line ? " (dashed); " : " (circles) with theirs; ") + realisations_in_words(report) + ". ";
  figure.caption += drawn.is_signed ? "Only realisations that reached the horizon are counted."
                                    : "A realisation that overturned counts as above every value; where too many did, "
                                      "a quantile or the end of an interval is not drawn.";
  figure.caption += slices_left_out(view);
  return figure;
}

}  // namespace

Table quantiles_of_condition(const Report& report, const ReportedCondition& condition) {
  const bool is_lone = condition.result.realisations == 1;
  Table table{.name = "", .columns = {{"quantity", "quantity"}}};
  if (is_lone) {
    table.columns.push_back({"value", "value"});
  } else {
    add_columns(report, "", table);
    table.columns.push_back({"n", "realisations"});
    table.columns.push_back({"beyond", "of these overturned"});
  }
  for (const Drawn& drawn : drawn_quantities) {
    const auto found = drawn.quantiles(condition.result.peaks);
    if (!found || found->levels.empty()) continue;
    Row& row = table.rows.emplace_back();
    row.emplace_back(label_of({.quantity = drawn.quantity, .symbol = drawn.symbol, .unit = drawn.unit}));
    if (is_lone) {
      row.emplace_back(quantile_at(found->levels, 0.5).value);
    } else {
      add_cells(*found, row);
      row.insert(row.end(), {found->realisations, found->beyond});
    }
  }
  return table;
}

std::vector<Figure> quantile_figures(const Report& report) {
  std::vector<Figure> figures;
  for (const Drawn& drawn : drawn_quantities) {
    if (shows_something(report, drawn)) figures.push_back(quantile_figure(report, drawn));
  }
  return figures;
}

}  // namespace rocking::analysis
