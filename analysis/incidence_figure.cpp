#include "analysis/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/settling_table.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_incidence_modes = 5;

/// A time axis that covers more than this ratio is logarithmic.
constexpr double linear_ratio = 10.0;

/// The conditions that are shown, ascending.
std::vector<std::size_t> shown_conditions(const Report& report) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    if (report.conditions[i].result.settling) shown.push_back(i);
  }
  const auto share = [&report](std::size_t i) {
    const ReportedCondition& each = report.conditions[i];
    return static_cast<double>(unresolved_at_horizon(each)) / static_cast<double>(each.result.realisations);
  };
  std::ranges::stable_sort(shown, std::greater{}, share);
  if (shown.size() > most_incidence_panels) shown.resize(most_incidence_panels);
  std::ranges::sort(shown);
  return shown;
}

/// The modes that are drawn; unresolved is none in which a response settles.
std::vector<ResponseMode> drawn_modes(const Report& report) {
  auto occurring = report.occurring();
  occurring.erase(ResponseMode{});
  return modes_to_show(occurring, most_incidence_modes);
}

/// Places of an axis of time.
struct Span {
  double low = 1.0;
  double high = 2.0;
};

/// From a little before the first change, or before the first fixed horizon if nothing changes, to the end of the
/// longest observation.
Span span_of(const Report& report, const std::vector<std::size_t>& shown) {
  double first = HUGE_VAL;
  double horizon = HUGE_VAL;
  double last = 0.0;
  for (const std::size_t i : shown) {
    const SettlingResult& incidence = *report.conditions[i].result.settling;
    if (const auto fixed = fixed_horizon(report.conditions[i]))
      horizon = std::min(horizon, static_cast<double>(*fixed));
    for (const auto& [mode, curve] : incidence.incidence) {
      if (curve.empty()) continue;
      first = std::min(first, static_cast<double>(curve.front().time));
      last = std::max(last, static_cast<double>(curve.back().time));
    }
    const auto limit = limit_of(report.conditions[i]);
    if (incidence.censored > 0 && limit) last = std::max(last, static_cast<double>(*limit));
  }
  if (!std::isfinite(first)) first = std::isfinite(horizon) ? horizon : 1.0;
  const double low = std::max(1.0, std::floor(0.8 * first));
  return {.low = low, .high = std::max(last, low + 1.0)};
}

using Curve = std::vector<stats::Incidence>;

/// The point of a step function that holds at `period`; zeros before its first change.
stats::Incidence point_at(const Curve& curve, double period) {
  const auto time = [](const stats::Incidence& point) { return static_cast<double>(point.time); };
  const auto after = std::ranges::upper_bound(curve, period, {}, time);
  return after == curve.begin() ? stats::Incidence{} : *std::prev(after);
}

std::set<double> places_of(const SettlingResult& incidence, const Span& span) {
  std::set<double> places{span.low, span.high};
  const auto add = [&places](const Curve& curve) {
    for (const stats::Incidence& point : curve) places.insert(static_cast<double>(point.time));
  };
  for (const auto& [mode, curve] : incidence.incidence) add(curve);
  add(incidence.times.any_mode);
  return places;
}

constexpr std::size_t columns_per_mode = 5;

Table table_of_incidence(const Report& report, const SettlingResult& incidence, const std::vector<ResponseMode>& modes,
                         const std::string& name, const Span& span) {
  const std::string level = report.level();
  Table table{.name = name,
              .columns = {{"period", "excitation periods since the start"},
                          {"not_settled", "probability of not having settled by then"}}};
  for (const ResponseMode& mode : modes) {
    const std::string of = to_string(mode);
    add_estimate(table,
                 {of, "probability of having settled in " + of + " by then", "pointwise " + level + " interval"});
    table.columns.push_back({of + "_band_low", "lower edge of its simultaneous " + level + " band"});
    table.columns.push_back({of + "_band_high", "upper edge of it"});
  }
  for (const double place : places_of(incidence, span)) {
    Row row{place, 1.0 - point_at(incidence.times.any_mode, place).estimate};
    for (const ResponseMode& mode : modes) {
      const auto found = incidence.incidence.find(mode);
      if (found == incidence.incidence.end()) {
        row.resize(row.size() + columns_per_mode);
        continue;
      }
      const stats::Incidence point = point_at(found->second, place);
      row.insert(row.end(), {point.estimate, point.pointwise.low, point.pointwise.high, point.simultaneous.low,
                             point.simultaneous.high});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Adds the band between LOW_low and LOW_high as a ribbon with the steps of its curve; ribbons join places by straight
/// lines.
void add_band(const Table& whole, const std::string& name, const Style& style, Figure& figure) {
  Table table = drawn_part(whole, "band of " + name + "_low: ", {"period", name + "_low", name + "_high"});
  std::vector<Row> stepped;
  for (const auto& row : table.rows) {
    if (!stepped.empty()) stepped.push_back({row[0], stepped.back()[1], stepped.back()[2]});
    stepped.push_back(row);
  }
  table.rows = std::move(stepped);
  add_drawn(std::move(table), {.kind = LayerKind::ribbon, .style = style}, figure);
}

/// Shades the time before the fixed horizon.
void add_horizon(std::int64_t horizon, const Span& span, Figure& figure) {
  const auto place = static_cast<double>(horizon);
  if (place <= span.low || span.high <= place) return;
  add_drawn(
      {.name = "fixed horizon",
       .columns = {{"from", "start of the shading"}, {"to", "fixed horizon"}},
       .rows = {{span.low, place}}},
      {.kind = LayerKind::spans, .style = {.colour = "#c8c8c8", .opacity = 0.25}, .legend = "up to the fixed horizon"},
      figure);
}

/// Of several swept parameters the values, `0.35/0.3, 6`: a panel is too narrow for their names, which the caption has.
std::string title_of(const Report& report, const ReportedCondition& condition) {
  if (report.swept.size() < 2) return name_of_condition(report, condition);
  std::string title;
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    title += (title.empty() ? "" : ", ") + short_value(condition.asked.parameters[i]);
  }
  return title;
}

std::string names_of_swept(const Report& report) {
  std::string names;
  for (const std::string& pointer : report.swept) {
    names += (names.empty() ? "" : ", ") + label_of(axis_of_parameter(pointer));
  }
  return names;
}

void add_panel(const Report& report, std::size_t condition, const std::vector<ResponseMode>& modes, const Span& span,
               Figure& figure) {
  const SettlingResult& incidence = *report.conditions[condition].result.settling;
  const std::string name = name_of_condition(report, report.conditions[condition]);
  const std::size_t table = figure.tables.size();
  figure.tables.push_back(
      table_of_incidence(report, incidence, modes, name.empty() ? "the only condition" : name, span));
  Panel panel{.title = title_of(report, report.conditions[condition]),
              .x = {.quantity = "time", .unit = "excitation periods", .low = span.low},
              .y = {.quantity = "probability", .low = 0.0, .high = 1.0}};
  panel.x.logarithmic = span.high > linear_ratio * span.low;
  panel.x.high = panel.x.logarithmic ? 1.2 * span.high : span.high + 0.04 * (span.high - span.low);
  figure.panels.push_back(std::move(panel));
  if (const auto horizon = fixed_horizon(report.conditions[condition])) add_horizon(*horizon, span, figure);
  const Table whole = figure.tables[table];
  for (const ResponseMode& mode : modes) {
    if (!incidence.incidence.contains(mode)) continue;
    add_band(whole, to_string(mode) + "_band", ribbon_of(style_of(mode), 0.1), figure);
    add_band(whole, to_string(mode), ribbon_of(style_of(mode)), figure);
  }
  Style style = style_of(ResponseMode{});
  style.colour = "#707070";
  style.dash = 5;
  style.width = 1.2;
  draw({.kind = LayerKind::steps, .table = table, .style = style, .legend = "not yet settled"}, {}, figure);
  for (const ResponseMode& mode : modes) {
    if (!incidence.incidence.contains(mode)) continue;
    const std::string label = to_string(mode);
    draw({.kind = LayerKind::steps, .table = table, .style = style_of(mode), .legend = label}, {"period", label},
         figure);
  }
}

}  // namespace

std::optional<Figure> incidence_figure(const Report& report) {
  const std::vector<std::size_t> shown = shown_conditions(report);
  if (shown.empty()) return std::nullopt;
  const std::vector<ResponseMode> modes = drawn_modes(report);
  const Span span = span_of(report, shown);
  Figure figure{.name = "incidence", .title = "Which response, and by when", .subtitle = report.title()};
  for (const std::size_t i : shown) add_panel(report, i, modes, span, figure);
  figure.caption =
      "Probability that a realisation has settled in a response mode by a time (cumulative incidence), with its " +
      report.level() +
      " interval at each time (darker) and its band for all times at once (lighter, of each mode alone). Realisations "
      "that were not classified are censored.";
  if (modes.empty()) figure.caption += " No realisation settled before the end of its observation.";
  if (report.occurring().size() > modes.size() + 1) figure.caption += " Rarer modes are not drawn.";
  if (report.swept.size() > 1) figure.caption += " Titles of panels: " + names_of_swept(report) + '.';
  if (report.conditions.size() > shown.size()) {
    figure.caption += " Shown are the " + std::to_string(shown.size()) +
                      " conditions in which most realisations are unresolved at the fixed horizon.";
  }
  return figure;
}

}  // namespace rocking::analysis
