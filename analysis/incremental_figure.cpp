#include "analysis/incremental_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/output_file.hpp"
#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Places of the quantiles of a level in `rocking.fragility/1`.
constexpr std::array<std::size_t, 3> lower_median_upper{0, 1, 2};
constexpr std::size_t median_place = 1;
constexpr std::size_t most_ticks = 6;

const Json& tilt_at(const Json& level, std::size_t quantile) { return level.at("quantiles").at(quantile).at(1); }

void take_largest(const Json& found, double& largest) {
  for (const Json& level : found) {
    for (const std::size_t quantile : lower_median_upper) {
      const Json& tilt = tilt_at(level, quantile);
      if (!tilt.is_null()) largest = std::max(largest, tilt.get<double>());
    }
  }
}

/// Distance of the ticks, 1, 2 or 5 times a power of ten, of an axis that reaches to `largest`.
double tick_distance(double largest) {
  const double least = largest / static_cast<double>(most_ticks - 1);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

/// The axis of the peak tilt; its last tick is the flat line of the overturned.
Axis tilt_axis(const Json& analysis) {
  double largest = 0.0;
  take_largest(analysis.at("levels"), largest);
  for (const Json& record : analysis.at("records")) take_largest(record.at("levels"), largest);
  if (!(largest > 0.0)) largest = 1.0;
  const double distance = tick_distance(largest);
  Axis axis{.quantity = "peak tilt", .symbol = "|Θ|", .unit = ""};
  double place = 0.0;
  for (int i = 0; place < largest; ++i, place = i * distance) {
    axis.ticks.push_back({.place = place, .text = significant(place, 6)});
  }
  const double flat = place + 0.5 * distance;
  axis.ticks.push_back({.place = flat, .text = "∞"});
  axis.low = 0.0;
  axis.high = flat + 0.25 * distance;
  return axis;
}

/// A number, or the flat line, or nothing.
Cell tilt_cell(const Json& tilt, std::optional<double> flat) {
  if (!tilt.is_null()) return tilt.get<double>();
  return flat ? Cell(*flat) : Cell();
}

/// Columns: intensity, realisations, how many overturned, the quantiles. `flat`: in place of overturned quantiles.
Table quantile_table(const Json& found, std::optional<double> flat) {
  Table table{.name = "all records",
              .columns = {{"intensity", "intensity of the excitation"},
                          {"n", "realisations"},
                          {"overturned", "number of them that overturned"},
                          {"q16", "16 % quantile of the peak tilt over psi"},
                          {"median", "median of it"},
                          {"q84", "84 % quantile of it"}},
              .rows = {}};
  table.only_drawn = flat.has_value();
  for (const Json& level : found) {
    table.rows.push_back({level.at("intensity").get<double>(), level.at("realisations").get<double>(),
                          level.at("overturned").get<double>()});
    for (const std::size_t quantile : lower_median_upper) {
      table.rows.back().push_back(tilt_cell(tilt_at(level, quantile), flat));
    }
  }
  return table;
}

/// Columns: intensity, the median of each record.
Table record_medians(const Json& records, std::optional<double> flat) {
  Table table{.name = "median of each record",
              .columns = {{"intensity", "intensity of the excitation"}},
              .rows = {},
              .grid = std::nullopt,
              .only_drawn = flat.has_value()};
  std::map<double, std::vector<Cell>> rows;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string name = short_value("/excitation/file", records.at(i).at("name"));
    table.columns.push_back({"record_" + std::to_string(i + 1), name, true});
    for (const Json& level : records.at(i).at("levels")) {
      std::vector<Cell>& row = rows[level.at("intensity").get<double>()];
      row.resize(1 + records.size());
      row[0] = level.at("intensity").get<double>();
      row[i + 1] = tilt_cell(tilt_at(level, median_place), flat);
    }
  }
  for (auto& [intensity, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

void add_records(const Json& records, double flat, Figure& figure) {
  const Style thin{.colour = "#999999", .width = 0.6, .size = 0.0};
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(record_medians(records, flat));
  for (std::size_t i = 1; i <= records.size(); ++i) {
    figure.panels.back().layers.push_back({.kind = LayerKind::line,
                                           .table = table,
                                           .columns = {0, i},
                                           .style = thin,
                                           .legend = i == 1 ? "median of a record" : ""});
  }
  figure.tables.push_back(record_medians(records, std::nullopt));
}

void add_quantiles(const Json& found, double flat, Figure& figure) {
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(quantile_table(found, flat));
  constexpr std::array<const char*, 3> names{"16 % and 84 % of all", "median of all", ""};
  for (const std::size_t quantile : lower_median_upper) {
    Style bold = style_of_curve(0);
    bold.width = quantile == median_place ? 3.0 : 2.0;
    bold.dash = quantile == median_place ? 1 : 2;
    bold.size = 0.0;
    figure.panels.back().layers.push_back({.kind = LayerKind::line,
                                           .table = table,
                                           .columns = {0, 3 + quantile},
                                           .style = bold,
                                           .legend = names[quantile]});
  }
  figure.tables.push_back(quantile_table(found, std::nullopt));
}

/// The flat line, over all levels. It is drawn first, below the others.
void add_flat_line(const Json& found, double flat, Figure& figure) {
  if (found.empty()) return;
  figure.panels.back().layers.push_back({.kind = LayerKind::line,
                                         .table = figure.tables.size(),
                                         .columns = {0, 1},
                                         .style = {.colour = "#000000", .dash = 3, .width = 1.0, .size = 0.0},
                                         .legend = "overturned"});
  Table table{.name = "overturned",
              .columns = {{"intensity", "intensity of the excitation"}, {"drawn", "where the overturned are drawn"}},
              .rows = {},
              .grid = std::nullopt,
              .only_drawn = true};
  for (const Json& level : found) table.rows.push_back({level.at("intensity").get<double>(), flat});
  figure.tables.push_back(std::move(table));
}

std::string resurrections_in_words(const Json& found) {
  return std::to_string(found.at("trials").get<std::uint64_t>()) + " of " +
         std::to_string(found.at("of").get<std::uint64_t>()) +
         " realisations that overturned at some level stood again at a stronger one";
}

void add_analysis(const Json& analysis, Figure& figure) {
  std::string others;
  for (const auto& [pointer, value] : analysis.at("others").items()) {
    others += (others.empty() ? "" : ", ") + axis_of_parameter(pointer).quantity + ' ' + short_value(pointer, value);
  }
  const std::string title = analysis.at("title").get<std::string>() + (others.empty() ? "" : ", ") + others;
  Axis tilt = tilt_axis(analysis);
  const double flat = tilt.ticks.back().place;
  figure.panels.push_back(
      {.title = title, .x = axis_of_parameter(analysis.at("parameter")), .y = std::move(tilt), .layers = {}});
  add_flat_line(analysis.at("levels"), flat, figure);
  add_records(analysis.at("records"), flat, figure);
  add_quantiles(analysis.at("levels"), flat, figure);
  figure.description += (figure.description.empty() ? "" : " ") + resurrections_in_words(analysis.at("resurrections")) +
                        (title.empty() ? "." : " (" + title + ").");
}

Figure drawn_analyses(const Json& analyses) {
  Figure figure;
  figure.name = "incremental";
  figure.title = "Incremental dynamic analysis";
  figure.caption =
      "Largest abs(theta)/psi of a realisation. Thin lines: median of each record. Thick lines: median (solid), 16 % "
      "and "
      "84 % quantiles (dashed) of all realisations of all records. A quantile that overturned lies on the flat line at "
      "the top; a line that comes down from it shows a resurrection.";
  for (const Json& analysis : analyses) add_analysis(analysis, figure);
  if (figure.panels.size() == 1) figure.subtitle = std::exchange(figure.panels.front().title, "");
  return figure;
}

}  // namespace

std::vector<Figure> incremental_figures(const Json& output) {
  std::vector<Figure> figures;
  read_or_refuse(output, [&] {
    if (output.contains("incremental") && !output.at("incremental").empty()) {
      figures.push_back(drawn_analyses(output.at("incremental")));
    }
  });
  return figures;
}

}  // namespace rocking::analysis
