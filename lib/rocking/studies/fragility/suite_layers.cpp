#include "rocking/studies/fragility/figure.hpp"

#include <map>
#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/stats/probit.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {

std::string event_in_words(const ResponseEvent& event) {
  return (event.name == EventName::tilt ? "peak " : "") + column_of(event);
}

std::string probability_of(const ResponseEvent& event) {
  return event.is_overturning() ? "overturning" : event_in_words(event);
}

namespace {

/// `width 0.42 m, all records`, or `peak tilt > 0.5, all records`.
std::string name_of(const SuiteCurve& curve, const std::string& what) {
  const std::string others = values_in_words(curve.subject.others);
  const std::string event = curve.subject.event.is_overturning() ? "" : event_in_words(curve.subject.event) + ", ";
  return (others.empty() ? "" : others + ", ") + event + what;
}

/// Columns: intensity, records, n, how many, estimate; then the probability by the law, or the isotonic share where none
/// holds, and its interval.
Table suite_table(const SuiteCurve& curve) {
  Table table{.name = name_of(curve, "all records"),
              .columns = {{"intensity", "intensity of the excitation"},
                          {"records", "records"},
                          {"n", "realisations of all records"},
                          {"happened", "of these: " + event_in_words(curve.subject.event)},
                          {"estimate", "mean over the records of their shares"}},
              .rows = {}};
  const std::string source = curve.has_law() ? "fitted" : "isotonic";
  table.columns.push_back({source, curve.has_law() ? "probability by the law of the suite"
                                                   : "nearest to the means at all levels that does not decrease"});
  table.columns.push_back({source + "_low", "lower end of its bootstrap interval"});
  table.columns.push_back({source + "_high", "upper end of it"});
  for (const SuiteLevel& level : curve.levels) {
    table.rows.push_back({level.intensity, static_cast<double>(level.records),
                          static_cast<double>(level.overturned.trials), static_cast<double>(level.overturned.successes),
                          level.estimate});
    auto& row = table.rows.back();
    const auto band = curve.has_law() ? level.band : std::optional(level.isotonic_band);
    row.push_back(curve.has_law() ? level.fitted.value() : level.isotonic);
    row.push_back(band ? Cell(band->low) : Cell());
    row.push_back(band ? Cell(band->high) : Cell());
  }
  return table;
}

/// Columns: intensity, the share of each record.
Table record_shares(const SuiteCurve& curve) {
  Table table{.name = name_of(curve, "share of each record"),
              .columns = {{"intensity", "intensity of the excitation"}},
              .rows = {}};
  std::map<double, std::vector<Cell>> rows;
  const std::vector<RecordCurve>& records = curve.records;
  for (std::size_t i = 0; i < records.size(); ++i) {
    table.columns.push_back(
        {"record_" + std::to_string(i + 1), short_value({"/excitation/file", records[i].name}), true});
    for (const FragilityLevel& level : records[i].curve.levels) {
      std::vector<Cell>& row = rows[level.intensity];
      row.resize(1 + records.size());
      row[0] = level.intensity;
      row[i + 1] = level.estimate;
    }
  }
  for (auto& [intensity, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

/// An edge of the band, known at the levels.
stats::ProbitInterpolation edge_of(const std::vector<SuiteLevel>& levels, double stats::Interval::*end) {
  std::vector<stats::KnownProbability> points;
  for (const SuiteLevel& level : levels) points.push_back({level.intensity, (*level.band).*end});
  return stats::ProbitInterpolation(points);
}

/// Columns: intensity, probability, low, high; without a band the last two are empty.
Table suite_law_table(const SuiteCurve& curve) {
  Table table{.name = "law, " + name_of(curve, "all records"),
              .columns = {{"intensity", "intensity of the excitation"},
                          {"law", "probability by the law of the suite"},
                          {"law_low", "lower edge of its bootstrap interval, interpolated between the levels"},
                          {"law_high", "upper edge of it"}},
              .rows = {}};
  const std::vector<SuiteLevel>& levels = curve.levels;
  const stats::SuiteLaw law = curve.pooled->law();
  const double first = levels.front().intensity;
  const double last = levels.back().intensity;
  for (int i = 0; i <= points_of_a_law; ++i) {
    const double intensity = first + (last - first) * i / points_of_a_law;
    table.rows.push_back({intensity, law.probability(intensity), Cell(), Cell()});
  }
  const bool has_band =
      levels.size() > 1 && std::ranges::all_of(levels, [](const SuiteLevel& level) { return level.band.has_value(); });
  if (!has_band) return table;
  const stats::ProbitInterpolation low = edge_of(levels, &stats::Interval::low);
  const stats::ProbitInterpolation high = edge_of(levels, &stats::Interval::high);
  for (auto& row : table.rows) {
    row[2] = low.probability(std::get<double>(row[0]));
    row[3] = high.probability(std::get<double>(row[0]));
  }
  return table;
}

/// Columns: intensity, probability, low, high.
Table rare_points(const std::vector<RareLevel>& levels, const std::string& legend) {
  Table table{.name = legend,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"rare", "small probability, by rocking rare"},
                          {"rare_low", "lower end of its interval"},
                          {"rare_high", "upper end of it"}},
              .rows = {}};
  for (const RareLevel& level : levels) {
    table.rows.push_back({level.intensity, level.probability, level.interval.low, level.interval.high});
  }
  return table;
}

}  // namespace

void add_rare(const std::vector<RareLevel>& levels, std::size_t number, const std::string& legend, Figure& figure) {
  if (levels.empty()) return;
  constexpr int diamond = 12;
  constexpr double larger = 1.2;
  Style style = style_of_curve(number);
  style.marker = diamond;
  style.size *= larger;
  const std::string name = (legend.empty() ? "" : legend + ", ") + "rare estimates";
  figure.panels.back().layers.push_back({.kind = LayerKind::error_bars,
                                         .table = figure.tables.size(),
                                         .columns = {0, 1, 2, 3},
                                         .style = style,
                                         .legend = name});
  figure.tables.push_back(rare_points(levels, name));
}

void add_suite(const SuiteCurve& curve, const PlaceInPanel& place, Figure& figure) {
  const auto& [number, is_alone] = place;
  Style thin = style_of_curve(number);
  thin.colour = "#999999";
  thin.width = 0.5;
  thin.marker = 0;
  Style line = style_of_curve(number);
  Style ribbon = line;
  ribbon.hatch = 0;
  ribbon.opacity = 0.2;
  line.width = 3.0;
  line.marker = 0;
  const std::size_t all = figure.tables.size();
  figure.tables.push_back(suite_table(curve));
  figure.tables.push_back(record_shares(curve));
  std::vector<Layer>& layers = figure.panels.back().layers;
  for (std::size_t i = 1; is_alone && i < figure.tables.back().columns.size(); ++i) {
    layers.push_back({.kind = LayerKind::line,
                      .table = all + 1,
                      .columns = {0, i},
                      .style = thin,
                      .legend = i == 1 ? "share of a record" : ""});
  }
  const std::string name = name_of(curve, "all records");
  const bool has_line = curve.levels.size() > 1;
  if (has_line) {
    // The table of the levels has the isotonic shares, each with its interval.
    const std::size_t table = curve.has_law() ? figure.tables.size() : all;
    const std::size_t first = curve.has_law() ? 1 : 5;
    if (curve.has_law()) figure.tables.push_back(suite_law_table(curve));
    if (!std::holds_alternative<std::monostate>(figure.tables[table].rows.front()[first + 1])) {
      layers.push_back(
          {.kind = LayerKind::ribbon, .table = table, .columns = {0, first + 1, first + 2}, .style = ribbon});
    }
    layers.push_back({.kind = LayerKind::line, .table = table, .columns = {0, first}, .style = line, .legend = name});
  }
  layers.push_back({.kind = LayerKind::points,
                    .table = all,
                    .columns = {0, 4},
                    .style = style_of_curve(number),
                    .legend = has_line ? "" : name});
  add_rare(curve.rare, number, name, figure);
}

}  // namespace rocking::analysis
