#include "analysis/fragility_figure.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/data_file.hpp"
#include "analysis/output_file.hpp"
#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/stats/probit_interpolation.hpp"
#include "rocking/stats/suite_law.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr int points_of_a_law = 120;

stats::LognormalFragility law_from(const Json& json) {
  const Json& covariance = json.at("covariance");
  stats::LognormalFragility law{.centre = json.at("centre"),
                                .intercept = json.at("intercept"),
                                .slope = json.at("slope"),
                                .covariance = {.aa = covariance.at(0), .ab = covariance.at(1), .bb = covariance.at(2)}};
  // Files of former versions have none: their intervals use the normal distribution.
  if (json.contains("degrees_of_freedom")) law.degrees_of_freedom = json.at("degrees_of_freedom");
  return law;
}

std::string name_of(const Json& curve) {
  std::string name;
  for (const auto& [pointer, value] : curve.at("others").items()) {
    name += (name.empty() ? "" : ", ") + axis_of_parameter(pointer).quantity + ' ' + short_value(pointer, value);
  }
  return name;
}

/// `overturned`, or `peak tilt > 0.5`.
std::string event_of(const Json& curve) {
  if (!curve.contains("event") || curve.at("event").is_string()) return "overturned";
  return "peak tilt > " + significant(curve.at("event").at("peak_tilt").get<double>(), 4);
}

/// Of what a probability is: `overturning`, or `peak tilt > 0.5`.
std::string subject_of(const Json& curve) {
  const std::string event = event_of(curve);
  return event == "overturned" ? "overturning" : event;
}

/// Columns: intensity, n, overturned, estimate, low, high.
Table level_table(const Json& curve, const std::string& name) {
  const std::string level = level_text(curve.at("confidence")) + " % interval";
  Table table{.name = name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"n", "realisations"},
                          {"overturned", "number of them: " + event_of(curve)},
                          {"estimate", "estimated probability of " + subject_of(curve)},
                          {"low", "lower end of its exact " + level},
                          {"high", "upper end of its exact " + level}},
              .rows = {}};
  for (const Json& found : curve.at("levels")) {
    table.rows.push_back({found.at("intensity").get<double>(), found.at("realisations").get<double>(),
                          found.at("overturned").get<double>(), found.at("estimate").get<double>(),
                          found.at("exact").at(0).get<double>(), found.at("exact").at(1).get<double>()});
  }
  return table;
}

/// Columns: intensity, probability, low, high.
Table law_table(const Json& curve, const std::string& name) {
  Table table{.name = "law of " + name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"law", "probability by the fitted lognormal function"},
                          {"law_low", "lower edge of its band"},
                          {"law_high", "upper edge of its band"}},
              .rows = {}};
  const stats::LognormalFragility law = law_from(curve.at("law"));
  const double confidence = curve.at("confidence");
  const double first = curve.at("levels").front().at("intensity");
  const double last = curve.at("levels").back().at("intensity");
  for (int i = 0; i <= points_of_a_law; ++i) {
    const double intensity = first + (last - first) * i / points_of_a_law;
    const stats::Interval band = law.band(intensity, confidence);
    table.rows.push_back({intensity, law.probability(intensity), band.low, band.high});
  }
  return table;
}

/// Whether the curve has the isotonic estimate; files of former versions have none.
bool is_isotonic(const Json& curve) {
  const Json& level = curve.at("levels").front();
  return level.contains("isotonic") && !level.at("isotonic").is_null();
}

/// Columns: intensity, next intensity, probability, low, high. Between two levels a probability that does not decrease
/// is at least the lower end of the band at the first and at most its upper end at the second.
Table isotonic_table(const Json& curve, const std::string& name) {
  const std::string level = level_text(curve.at("confidence")) + " % band of all levels at once";
  Table table{.name = "isotonic estimate of " + name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"next", "the next intensity"},
                          {"isotonic", "most likely probability that does not decrease"},
                          {"isotonic_low", "lower edge, up to the next intensity, of its " + level},
                          {"isotonic_high", "upper edge, up to the next intensity, of it"}},
              .rows = {}};
  const Json& rows = curve.at("levels");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Json& next = rows.at(std::min(i + 1, rows.size() - 1));
    table.rows.push_back({rows.at(i).at("intensity").get<double>(), next.at("intensity").get<double>(),
                          rows.at(i).at("isotonic").get<double>(), rows.at(i).at("band").at(0).get<double>(),
                          next.at("band").at(1).get<double>()});
  }
  return table;
}

void add_isotonic(const Json& curve, const std::string& name, const Style& style, Figure& figure) {
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(isotonic_table(curve, name));
  Style band = style;
  band.hatch = 0;
  band.opacity = 0.2;
  std::vector<Layer>& layers = figure.panels.back().layers;
  layers.push_back({.kind = LayerKind::boxes, .table = table, .columns = {0, 1, 3, 4}, .style = band});
  layers.push_back({.kind = LayerKind::steps, .table = table, .columns = {0, 2}, .style = style});
}

/// The values of the other parameters, and the event unless it is an overturning; empty if there is neither.
std::string legend_of(const Json& curve) {
  const std::string name = name_of(curve);
  const std::string event = event_of(curve);
  if (event == "overturned") return name;
  return name.empty() ? event : name + ", " + event;
}

void add_curve(const Json& curve, std::size_t number, Figure& figure) {
  Panel& panel = figure.panels.back();
  const std::string name = name_of(curve).empty() ? curve.at("title").get<std::string>() : name_of(curve);
  Style style = style_of_curve(number);
  if (!curve.at("law").is_null()) {
    figure.tables.push_back(law_table(curve, name));
    const std::size_t law = figure.tables.size() - 1;
    Style ribbon = style;
    ribbon.hatch = 0;
    ribbon.opacity = 0.2;
    Style line = style;
    line.size = 0.0;
    panel.layers.push_back({.kind = LayerKind::ribbon, .table = law, .columns = {0, 2, 3}, .style = ribbon});
    panel.layers.push_back({.kind = LayerKind::line, .table = law, .columns = {0, 1}, .style = line});
  }
  if (is_isotonic(curve)) add_isotonic(curve, name, style, figure);
  figure.tables.push_back(level_table(curve, name));
  panel.layers.push_back({.kind = LayerKind::error_bars,
                          .table = figure.tables.size() - 1,
                          .columns = {0, 3, 4, 5},
                          .style = style,
                          .legend = legend_of(curve)});
}

bool is_suite(const Json& curve) { return curve.contains("pooled"); }

/// Columns: intensity, records, n, how many, estimate; with a law `fitted` and its band.
Table suite_table(const Json& curve) {
  Table table{.name = event_of(curve) + ", all records",
              .columns = {{"intensity", "intensity of the excitation"},
                          {"records", "records"},
                          {"n", "realisations of all records"},
                          {"happened", "number of them with " + event_of(curve)},
                          {"estimate", "mean over the records of their shares"},
                          {"fitted", "probability by the law of the suite"},
                          {"fitted_low", "lower end of its bootstrap interval"},
                          {"fitted_high", "upper end of it"}},
              .rows = {}};
  const auto number = [](const Json& value) { return value.is_null() ? Cell() : Cell(value.get<double>()); };
  for (const Json& level : curve.at("levels")) {
    const Json& band = level.at("band");
    table.rows.push_back({number(level.at("intensity")), number(level.at("records")), number(level.at("realisations")),
                          number(level.at("overturned")), number(level.at("estimate")), number(level.at("fitted")),
                          band.is_null() ? Cell() : number(band.at(0)), band.is_null() ? Cell() : number(band.at(1))});
  }
  return table;
}

/// Columns: intensity, the share of each record.
Table record_shares(const Json& curve) {
  Table table{.name = event_of(curve) + ", share of each record",
              .columns = {{"intensity", "intensity of the excitation"}},
              .rows = {}};
  std::map<double, std::vector<Cell>> rows;
  const Json& records = curve.at("records");
  for (std::size_t i = 0; i < records.size(); ++i) {
    table.columns.push_back(
        {"record_" + std::to_string(i + 1), short_value("/excitation/file", records.at(i).at("name")), true});
    for (const Json& level : records.at(i).at("levels")) {
      std::vector<Cell>& row = rows[level.at("intensity").get<double>()];
      row.resize(1 + records.size());
      row[0] = level.at("intensity").get<double>();
      row[i + 1] = level.at("estimate").get<double>();
    }
  }
  for (auto& [intensity, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

stats::SuiteLaw suite_law_from(const Json& pooled) {
  const auto value = [&pooled](const char* key) { return pooled.at(key).at("value").get<double>(); };
  return {
      .median = value("median"), .between_records = value("between_records"), .within_record = value("within_record")};
}

/// An edge of the band, known at the levels.
stats::ProbitInterpolation edge_of(const Json& rows, std::size_t end) {
  std::vector<stats::KnownProbability> points;
  for (const Json& level : rows) points.push_back({level.at("intensity"), level.at("band").at(end)});
  return stats::ProbitInterpolation(points);
}

/// Columns: intensity, probability, low, high; without a band the last two are empty.
Table suite_law_table(const Json& curve) {
  Table table{.name = "law of " + event_of(curve) + ", all records",
              .columns = {{"intensity", "intensity of the excitation"},
                          {"law", "probability by the law of the suite"},
                          {"law_low", "lower edge of its bootstrap interval, interpolated between the levels"},
                          {"law_high", "upper edge of it"}},
              .rows = {}};
  const Json& rows = curve.at("levels");
  const bool has_band = rows.size() > 1 && std::none_of(rows.begin(), rows.end(),
                                                        [](const Json& level) { return level.at("band").is_null(); });
  const stats::SuiteLaw law = suite_law_from(curve.at("pooled"));
  const double first = rows.front().at("intensity");
  const double last = rows.back().at("intensity");
  for (int i = 0; i <= points_of_a_law; ++i) {
    const double intensity = first + (last - first) * i / points_of_a_law;
    table.rows.push_back({intensity, law.probability(intensity), Cell(), Cell()});
  }
  if (!has_band) return table;
  for (const std::size_t end : {0U, 1U}) {
    const stats::ProbitInterpolation edge = edge_of(rows, end);
    for (auto& row : table.rows) row[2 + end] = edge.probability(std::get<double>(row[0]));
  }
  return table;
}

/// A thin line through the shares of each record of a suite, the means of these shares as markers, and the law of the
/// suite with its band.
void add_suite(const Json& curve, std::size_t number, Figure& figure) {
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
  for (std::size_t i = 1; i < figure.tables.back().columns.size(); ++i) {
    layers.push_back({.kind = LayerKind::line,
                      .table = all + 1,
                      .columns = {0, i},
                      .style = thin,
                      .legend = i == 1 && number == 0 ? "share of a record" : ""});
  }
  const std::string name = event_of(curve) + ", all records";
  const bool has_law = !curve.at("pooled").is_null();
  if (has_law) {
    const std::size_t law = figure.tables.size();
    figure.tables.push_back(suite_law_table(curve));
    if (!std::holds_alternative<std::monostate>(figure.tables.back().rows.front()[2])) {
      layers.push_back({.kind = LayerKind::ribbon, .table = law, .columns = {0, 2, 3}, .style = ribbon});
    }
    layers.push_back({.kind = LayerKind::line, .table = law, .columns = {0, 1}, .style = line, .legend = name});
  }
  layers.push_back({.kind = LayerKind::points,
                    .table = all,
                    .columns = {0, 4},
                    .style = style_of_curve(number),
                    .legend = has_law ? "" : name});
}

Panel panel_for(const Json& curve) {
  return {.title = curve.at("title"),
          .x = axis_of_parameter(curve.at("parameter"), shakings_in(curve.at("levels"))),
          .y = {.quantity = "probability of " + subject_of(curve), .symbol = "P", .unit = "", .low = 0.0, .high = 1.0},
          .layers = {}};
}

/// `2.31 [2.20, 2.43]`.
std::string value_and_interval(const Json& bounded) {
  const Json& interval = bounded.at("interval");
  return significant(bounded.at("value"), 3) + " [" + significant(interval.at(0), 3) + ", " +
         (interval.at(1).is_null() ? "unbounded" : significant(interval.at(1), 3)) + ']';
}

std::string median_of(const Json& curve) {
  const Json& median = curve.at("law").at("median");
  const bool is_extrapolated = median.contains("extrapolated") && median.at("extrapolated").get<bool>();
  return value_and_interval(median) + (is_extrapolated ? " (extrapolated beyond the levels)" : "");
}

/// Files of former versions have no least uplift.
std::string uplift_sentence(const Json& curve) {
  if (!curve.contains("least_uplift") || curve.at("least_uplift").is_null()) return "";
  return " The block is not lifted below " + significant(curve.at("least_uplift").get<double>(), 4) +
         ": a probability that a law gives there is impossible.";
}

std::string description_of(const Json& curve) {
  if (is_suite(curve)) {
    const std::string begin = curve.at("title").get<std::string>() + ": ";
    if (curve.at("pooled").is_null())
      return begin + "no law of the suite (" + curve.at("outcome").get<std::string>() + ").";
    return begin + "median " + value_and_interval(curve.at("pooled").at("median")) + ", dispersion " +
           value_and_interval(curve.at("pooled").at("dispersion")) + '.' + uplift_sentence(curve);
  }
  std::string text = curve.at("title").get<std::string>() + (name_of(curve).empty() ? "" : ", " + name_of(curve)) +
                     ", " + subject_of(curve);
  if (is_isotonic(curve)) return text + ": the lognormal function is rejected; isotonic estimate.";
  if (curve.at("law").is_null()) return text + ": no function fitted (" + curve.at("outcome").get<std::string>() + ").";
  return text + ": median " + median_of(curve) + ", dispersion " +
         value_and_interval(curve.at("law").at("dispersion")) + '.' + uplift_sentence(curve);
}

/// A text that all curves have in common; otherwise empty.
std::string common_text(const Json& curves, std::string (*text_of)(const Json&)) {
  if (curves.empty()) return "";
  const std::string text = text_of(curves.front());
  const auto is_same = [&](const Json& curve) { return text_of(curve) == text; };
  return std::all_of(curves.begin(), curves.end(), is_same) ? text : "";
}

/// How to read the lines, as far as the figure has them.
std::string caption_of(const Json& curves) {
  const auto has = [&curves](const auto& is_so) {
    return std::any_of(curves.begin(), curves.end(), [&is_so](const Json& curve) {
      return !curve.at("levels").empty() && !is_suite(curve) && is_so(curve);
    });
  };
  std::string caption;
  if (std::any_of(curves.begin(), curves.end(), is_suite)) {
    caption =
        "Thin grey lines: shares of the realisations of each record. Markers: their means over the records. Thick "
        "lines "
        "and ribbons: the law of the suite, with scatter between and within records, and its bootstrap interval over "
        "records at the levels, interpolated between them.";
  }
  if (!has([](const Json&) { return true; })) return caption;
  if (!caption.empty()) caption += ' ';
  const std::string event = common_text(curves, event_of);
  caption += "Markers: share of the realisations " +
             (event == "overturned" ? std::string("that overturned")
              : event.empty()       ? std::string("with the event of each curve")
                                    : "with " + event) +
             ", with its exact interval.";
  if (has([](const Json& curve) { return !curve.at("law").is_null(); })) {
    caption += " Lines and ribbons: the lognormal function of maximum likelihood, with its confidence band.";
  }
  if (has(is_isotonic)) {
    caption +=
        " Steps and boxes: the most likely probabilities that do not decrease, with a band for all levels at once.";
  }
  return caption;
}

Figure drawn(const Json& output) {
  Figure figure;
  figure.name = "fragility";
  const std::string subject = common_text(output.at("curves"), subject_of);
  figure.title = "Probability" + (subject.empty() ? "" : " of " + subject) + " as a function of intensity";
  figure.caption = caption_of(output.at("curves"));
  std::string run;
  std::size_t number = 0;
  for (const Json& curve : output.at("curves")) {
    if (curve.at("levels").empty()) continue;
    if (figure.panels.empty() || curve.at("sha256") != run) {
      figure.panels.push_back(panel_for(curve));
      run = curve.at("sha256");
      number = 0;
    } else if (figure.panels.back().y.quantity != "probability of " + subject_of(curve)) {
      figure.panels.back().y.quantity = "probability";
    }
    if (is_suite(curve)) {
      add_suite(curve, number++, figure);
    } else {
      add_curve(curve, number++, figure);
    }
    figure.description += (figure.description.empty() ? "" : " ") + description_of(curve);
  }
  if (figure.panels.size() == 1) figure.subtitle = std::exchange(figure.panels.front().title, "");
  return figure;
}

}  // namespace

std::vector<Figure> fragility_figures(const Json& output) {
  std::vector<Figure> figures;
  read_or_refuse(output, [&] { figures = {drawn(output)}; });
  return figures;
}

}  // namespace rocking::analysis
