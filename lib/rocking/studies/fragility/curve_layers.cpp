#include "rocking/studies/fragility/figure.hpp"

#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Columns: intensity, n, overturned, estimate, low, high.
Table level_table(const FragilityCurve& curve, const std::string& name) {
  const std::string level = level_text(curve.subject.confidence) + " % interval";
  Table table{.name = name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"n", "realisations"},
                          {"overturned", "of these: " + event_in_words(curve.subject.event)},
                          {"estimate", "estimated probability of " + probability_of(curve.subject.event)},
                          {"low", "lower end of its exact " + level},
                          {"high", "upper end of its exact " + level}},
              .rows = {}};
  for (const FragilityLevel& found : curve.levels) {
    table.rows.push_back({found.intensity, static_cast<double>(found.overturned.trials),
                          static_cast<double>(found.overturned.successes), found.estimate, found.exact.low,
                          found.exact.high});
  }
  return table;
}

/// Columns: intensity, probability, low, high.
Table law_table(const FragilityCurve& curve, const std::string& name) {
  Table table{.name = "law of " + name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"law", "probability by the fitted lognormal function"},
                          {"law_low", "lower edge of its band"},
                          {"law_high", "upper edge of its band"}},
              .rows = {}};
  const stats::LognormalFragility& law = curve.law->function;
  const double first = curve.levels.front().intensity;
  const double last = curve.levels.back().intensity;
  for (int i = 0; i <= points_of_a_law; ++i) {
    const double intensity = first + (last - first) * i / points_of_a_law;
    const stats::Interval band = law.band(intensity, curve.subject.confidence);
    table.rows.push_back({intensity, law.probability(intensity), band.low, band.high});
  }
  return table;
}

/// Columns: intensity, next intensity, probability, low, high. Between two levels a probability that does not decrease
/// is at least the lower end of the band at the first and at most its upper end at the second.
Table isotonic_table(const FragilityCurve& curve, const std::string& name) {
  const std::string level = level_text(curve.subject.confidence) + " % band of all levels at once";
  Table table{.name = "isotonic estimate of " + name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"next", "the next intensity"},
                          {"isotonic", "most likely probability that does not decrease"},
                          {"isotonic_low", "lower edge, up to the next intensity, of its " + level},
                          {"isotonic_high", "upper edge, up to the next intensity, of it"}},
              .rows = {}};
  const std::vector<FragilityLevel>& levels = curve.levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const FragilityLevel& next = levels[std::min(i + 1, levels.size() - 1)];
    table.rows.push_back(
        {levels[i].intensity, next.intensity, *levels[i].isotonic, levels[i].simultaneous.low, next.simultaneous.high});
  }
  return table;
}

void add_isotonic(const FragilityCurve& curve, const std::string& name, const Style& style, Figure& figure) {
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
std::string legend_of(const CurveSubject& subject) {
  const std::string name = values_in_words(subject.others);
  if (subject.event.is_overturning()) return name;
  return (name.empty() ? "" : name + ", ") + event_in_words(subject.event);
}

}  // namespace

void add_curve(const ReportedCurve& reported, const PlaceInPanel& place, Figure& figure) {
  const FragilityCurve& curve = reported.curve;
  Panel& panel = figure.panels.back();
  const std::string others = values_in_words(curve.subject.others);
  const std::string& name = others.empty() ? reported.run.title : others;
  Style style = style_of_curve(place.number);
  if (curve.law) {
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
  if (curve.is_isotonic()) add_isotonic(curve, name, style, figure);
  figure.tables.push_back(level_table(curve, name));
  panel.layers.push_back({.kind = LayerKind::error_bars,
                          .table = figure.tables.size() - 1,
                          .columns = {0, 3, 4, 5},
                          .style = style,
                          .legend = legend_of(curve.subject)});
  add_rare(curve.rare, place.number, legend_of(curve.subject), figure);
}

}  // namespace rocking::analysis
