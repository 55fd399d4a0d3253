#include "rocking/studies/incremental/look.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Of the quantiles of a level.
constexpr std::size_t median_place = 1;
constexpr std::array<const char*, 3> quantile_names{"q16", "median", "q84"};
constexpr std::size_t most_ticks = 6;

void take_largest(const std::vector<PeakTiltLevel>& levels, double& largest) {
  for (const PeakTiltLevel& level : levels) {
    for (const auto& tilt : level.quantiles) largest = std::max(largest, tilt.value_or(0.0));
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
Axis tilt_axis(const IncrementalAnalysis& analysis) {
  double largest = 0.0;
  take_largest(analysis.all, largest);
  for (const PeakTiltCurve& record : analysis.records) take_largest(record.levels, largest);
  if (!(largest > 0.0)) largest = 1.0;
  const double distance = tick_distance(largest);
  Axis axis{.quantity = "peak tilt", .symbol = "|Θ|"};
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

/// Columns: intensity, realisations, how many overturned, the quantiles. `flat`: in place of overturned quantiles.
Table quantile_table(const std::vector<PeakTiltLevel>& levels, std::optional<double> flat) {
  Table table{.name = "all records",
              .columns = {{"intensity", "intensity of the excitation"},
                          {"n", "realisations"},
                          {"overturned", "of these overturned"},
                          {"q16", "16 % quantile of the peak tilt over psi"},
                          {"median", "median of the peak tilt over psi"},
                          {"q84", "84 % quantile of the peak tilt over psi"}}};
  table.only_drawn = flat.has_value();
  for (const PeakTiltLevel& level : levels) {
    table.rows.push_back({level.intensity, level.trials, level.overturned});
    for (const auto& tilt : level.quantiles) table.rows.back().push_back(tilt ? tilt : flat);
  }
  return table;
}

/// Columns: intensity, the median of each record.
Table record_medians(const std::vector<PeakTiltCurve>& records, std::optional<double> flat) {
  Table table{.name = "median of each record",
              .columns = {{"intensity", "intensity of the excitation"}},
              .only_drawn = flat.has_value()};
  std::map<double, Row> rows;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string name = short_value({"/excitation/file", records[i].record});
    table.columns.push_back({"record_" + std::to_string(i + 1), name, "", true});
    for (const PeakTiltLevel& level : records[i].levels) {
      Row& row = rows[level.intensity];
      row.resize(1 + records.size());
      row[0] = level.intensity;
      const auto& tilt = level.quantiles[median_place];
      row[i + 1] = tilt ? tilt : flat;
    }
  }
  for (auto& [intensity, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

void add_records(const std::vector<PeakTiltCurve>& records, double flat, Figure& figure) {
  const Style thin{.colour = "#999999", .width = 0.6, .size = 0.0};
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(record_medians(records, flat));
  for (std::size_t i = 1; i <= records.size(); ++i) {
    draw({.kind = LayerKind::line, .table = table, .style = thin, .legend = i == 1 ? "median of a record" : ""},
         {"intensity", "record_" + std::to_string(i)}, figure);
  }
  figure.tables.push_back(record_medians(records, std::nullopt));
}

void add_quantiles(const std::vector<PeakTiltLevel>& levels, double flat, Figure& figure) {
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(quantile_table(levels, flat));
  constexpr std::array<const char*, 3> legends{"16 % and 84 % of all", "median of all", ""};
  for (std::size_t quantile = 0; quantile < peak_tilt_shares.size(); ++quantile) {
    Style bold = style_of_curve(0);
    bold.width = quantile == median_place ? 3.0 : 2.0;
    bold.dash = quantile == median_place ? 1 : 2;
    bold.size = 0.0;
    draw({.kind = LayerKind::line, .table = table, .style = bold, .legend = legends[quantile]},
         {"intensity", quantile_names[quantile]}, figure);
  }
  figure.tables.push_back(quantile_table(levels, std::nullopt));
}

/// The flat line, over all levels. It is drawn first, below the others.
void add_flat_line(const std::vector<PeakTiltLevel>& levels, double flat, Figure& figure) {
  if (levels.empty()) return;
  Table table{.name = "overturned",
              .columns = {{"intensity", "intensity of the excitation"}, {"drawn", "where the overturned are drawn"}},
              .only_drawn = true};
  for (const PeakTiltLevel& level : levels) table.rows.push_back({level.intensity, flat});
  draw(std::move(table),
       {.kind = LayerKind::line,
        .style = {.colour = "#000000", .dash = 3, .width = 1.0, .size = 0.0},
        .legend = "overturned"},
       {}, figure);
}

void add_analysis(const ReportedAnalysis& reported, Figure& figure) {
  const IncrementalAnalysis& analysis = reported.analysis;
  const std::string others = values_in_words(analysis.others);
  const std::string title = reported.run.title + (others.empty() ? "" : ", ") + others;
  Axis tilt = tilt_axis(analysis);
  const double flat = tilt.ticks.back().place;
  figure.panels.push_back({.title = title, .x = axis_of_parameter(analysis.parameter), .y = std::move(tilt)});
  add_flat_line(analysis.all, flat, figure);
  add_records(analysis.records, flat, figure);
  add_quantiles(analysis.all, flat, figure);
  figure.description += (figure.description.empty() ? "" : " ") + resurrections_in_words(analysis.resurrections) +
                        (title.empty() ? "." : " (" + title + ").");
}

}  // namespace

std::optional<Figure> incremental_figure(const std::vector<ReportedAnalysis>& analyses) {
  if (analyses.empty()) return std::nullopt;
  Figure figure{.name = "incremental", .title = "Incremental dynamic analysis"};
  figure.caption =
      "Largest abs(theta)/psi of a realisation. Thin lines: median of each record. Thick lines: median (solid), 16 % "
      "and 84 % quantiles (dashed) of all realisations of all records. A quantile that overturned lies on the flat "
      "line at the top; a line that comes down from it shows a resurrection.";
  for (const ReportedAnalysis& reported : analyses) add_analysis(reported, figure);
  if (figure.panels.size() == 1) figure.subtitle = std::exchange(figure.panels.front().title, "");
  return figure;
}

}  // namespace rocking::analysis
