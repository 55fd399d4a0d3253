#include "rocking/studies/fragility/figure.hpp"

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Columns: intensity, n, overturned, estimate, low, high.
Table level_table(const FragilityCurve& curve, const std::string& name) {
  const std::string level = level_text(curve.subject.confidence) + " % interval";
  Table table{
      .name = name,
      .columns = {{"intensity", "intensity of the excitation"},
                  {"n", "realisations"},
                  {"overturned", "of these: " + event_in_words(curve.subject.event)},
                  {"estimate", "estimated probability of " + probability_of(curve.subject.event), "exact " + level},
                  {"low", "lower end of its exact " + level},
                  {"high", "upper end of its exact " + level}}};
  for (const FragilityLevel& found : curve.levels) {
    table.rows.push_back({found.intensity, found.overturned.trials, found.overturned.successes, found.estimate,
                          found.exact.low, found.exact.high});
  }
  return table;
}

/// Columns: intensity, probability, low, high.
Table law_table(const FragilityCurve& curve, const std::string& name) {
  Table table{.name = "law of " + name,
              .columns = {{"intensity", "intensity of the excitation"},
                          {"law", "probability by the fitted lognormal function", "band"},
                          {"law_low", "lower edge of its band"},
                          {"law_high", "upper edge of its band"}}};
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
                          {"isotonic", "most likely probability that does not decrease", level},
                          {"isotonic_low", "lower edge, up to the next intensity, of its " + level},
                          {"isotonic_high", "upper edge, up to the next intensity, of it"}}};
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
  draw(isotonic_table(curve, name), {.kind = LayerKind::boxes, .style = ribbon_of(style)},
       {"intensity", "next", "isotonic_low", "isotonic_high"}, figure);
  draw({.kind = LayerKind::steps, .table = table, .style = style}, {"intensity", "isotonic"}, figure);
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
  const std::string others = values_in_words(curve.subject.others);
  const std::string& name = others.empty() ? reported.run.title : others;
  Style style = style_of_curve(place.number);
  if (curve.law) {
    const std::size_t law = figure.tables.size();
    draw(law_table(curve, name), {.kind = LayerKind::ribbon, .style = ribbon_of(style)},
         {"intensity", "law_low", "law_high"}, figure);
    Style line = style;
    line.size = 0.0;
    draw({.kind = LayerKind::line, .table = law, .style = line}, {}, figure);
  }
  if (curve.is_isotonic()) add_isotonic(curve, name, style, figure);
  draw(level_table(curve, name), {.kind = LayerKind::error_bars, .style = style, .legend = legend_of(curve.subject)},
       {"intensity", "estimate", "low", "high"}, figure);
  add_rare(curve.rare, place.number, legend_of(curve.subject), figure);
}

}  // namespace rocking::analysis
