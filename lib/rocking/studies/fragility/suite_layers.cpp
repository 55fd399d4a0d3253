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
                          {"estimate", "mean over the records of their shares"}}};
  const std::string source = curve.has_law() ? "fitted" : "isotonic";
  add_estimate(table, {source,
                       curve.has_law() ? "probability by the law of the suite"
                                       : "nearest to the means at all levels that does not decrease",
                       "bootstrap interval"});
  for (const SuiteLevel& level : curve.levels) {
    const auto band = curve.has_law() ? level.band : std::optional(level.isotonic_band);
    table.rows.push_back({level.intensity, level.records, level.overturned.trials, level.overturned.successes,
                          level.estimate, curve.has_law() ? level.fitted.value() : level.isotonic,
                          band ? Cell(band->low) : Cell(), band ? Cell(band->high) : Cell()});
  }
  return table;
}

/// Columns: intensity, the share of each record.
Table record_shares(const SuiteCurve& curve) {
  Table table{.name = name_of(curve, "share of each record"),
              .columns = {{"intensity", "intensity of the excitation"}}};
  std::map<double, Row> rows;
  const std::vector<RecordCurve>& records = curve.records;
  for (std::size_t i = 0; i < records.size(); ++i) {
    table.columns.push_back(
        {"record_" + std::to_string(i + 1), short_value({"/excitation/file", records[i].name}), "", true});
    for (const FragilityLevel& level : records[i].curve.levels) {
      Row& row = rows[level.intensity];
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
  Table table{
      .name = "law, " + name_of(curve, "all records"),
      .columns = {{"intensity", "intensity of the excitation"},
                  {"law", "probability by the law of the suite", "bootstrap interval, interpolated between the levels"},
                  {"law_low", "lower edge of its bootstrap interval, interpolated between the levels"},
                  {"law_high", "upper edge of it"}}};
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
  Table table{.name = legend, .columns = {{"intensity", "intensity of the excitation"}}};
  add_estimate(table, {"rare", "small probability, by rocking rare", "interval"});
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
  draw(rare_points(levels, name), {.kind = LayerKind::error_bars, .style = style, .legend = name}, {}, figure);
}

void add_suite(const SuiteCurve& curve, const PlaceInPanel& place, Figure& figure) {
  const auto& [number, is_alone] = place;
  Style thin = style_of_curve(number);
  thin.colour = "#999999";
  thin.width = 0.5;
  thin.marker = 0;
  Style line = style_of_curve(number);
  const std::size_t all = figure.tables.size();
  figure.tables.push_back(suite_table(curve));
  figure.tables.push_back(record_shares(curve));
  for (std::size_t i = 1; is_alone && i <= curve.records.size(); ++i) {
    draw({.kind = LayerKind::line, .table = all + 1, .style = thin, .legend = i == 1 ? "share of a record" : ""},
         {"intensity", "record_" + std::to_string(i)}, figure);
  }
  const std::string name = name_of(curve, "all records");
  const bool has_line = curve.levels.size() > 1;
  if (has_line) {
    // The table of the levels has the isotonic shares, each with its interval.
    const std::size_t table = curve.has_law() ? figure.tables.size() : all;
    const std::string source = curve.has_law() ? "law" : "isotonic";
    if (curve.has_law()) figure.tables.push_back(suite_law_table(curve));
    const std::size_t low = places_of(figure.tables[table], {source + "_low"}).front();
    if (!std::holds_alternative<std::monostate>(figure.tables[table].rows.front()[low])) {
      draw({.kind = LayerKind::ribbon, .table = table, .style = ribbon_of(line)},
           {"intensity", source + "_low", source + "_high"}, figure);
    }
    line.width = 3.0;
    line.marker = 0;
    draw({.kind = LayerKind::line, .table = table, .style = line, .legend = name}, {"intensity", source}, figure);
  }
  draw({.kind = LayerKind::points, .table = all, .style = style_of_curve(number), .legend = has_line ? "" : name},
       {"intensity", "estimate"}, figure);
  add_rare(curve.rare, number, name, figure);
}

}  // namespace rocking::analysis
