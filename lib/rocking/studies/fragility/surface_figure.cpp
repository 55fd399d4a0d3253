#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rocking/figures/shaded_map.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/studies/fragility/figure.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::array<ShadeClass, 7> probabilities{{{0.9, "0.9 to 1"},
                                                   {0.75, "0.75 to 0.9"},
                                                   {0.5, "0.5 to 0.75"},
                                                   {0.25, "0.25 to 0.5"},
                                                   {0.1, "0.1 to 0.25"},
                                                   {0.01, "0.01 to 0.1"},
                                                   {0.0, "below 0.01"}}};
constexpr std::array<ShadeClass, 6> widths{{{0.6, "above 0.6"},
                                            {0.4, "0.4 to 0.6"},
                                            {0.3, "0.3 to 0.4"},
                                            {0.2, "0.2 to 0.3"},
                                            {0.1, "0.1 to 0.2"},
                                            {0.0, "below 0.1"}}};

/// By the places of surface_measure_names.
Axis axis_of(const std::string& measure) {
  static const std::array<Axis, surface_measure_names.size()> axes{
      {{.quantity = "peak ground acceleration", .symbol = "PGA", .unit = "g"},
       {.quantity = "peak ground velocity", .symbol = "PGV", .unit = "m/s"},
       {.quantity = "spectral acceleration at 2π/p", .unit = "g"},
       {.quantity = "spectral acceleration", .symbol = "Sa", .unit = "g"},
       {.quantity = "average spectral acceleration", .unit = "g"},
       {.quantity = "absolute spectral acceleration", .unit = "g"},
       {.quantity = "PGV/PGA", .unit = "s"}}};
  const auto* const place = std::ranges::find(surface_measure_names, measure);
  Axis axis = axes.at(static_cast<std::size_t>(place - surface_measure_names.begin()));
  axis.logarithmic = true;
  return axis;
}

/// Of points on equal ratios, the first and last cells are half as wide.
std::vector<double> edges(const std::vector<double>& points) {
  std::vector<double> found{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) found.push_back(std::sqrt(points[i - 1] * points[i]));
  found.push_back(points.back());
  return found;
}

/// A number of each point that is not extrapolated.
template <class Number>
ShadedMap map_of(const FragilitySurface& surface, Number&& number) {
  std::vector<double> x, y;
  ShadedMap map;
  for (const SurfacePoint& point : surface.map) {
    if (y.empty() || y.back() != point.y) {
      y.push_back(point.y);
      map.numbers.emplace_back();
    }
    if (y.size() == 1) x.push_back(point.x);
    map.numbers.back().push_back(point.is_extrapolated ? std::numeric_limits<double>::quiet_NaN() : number(point));
  }
  map.x_edges = edges(x);
  map.y_edges = edges(y);
  return map;
}

/// Where the probability is 1/2, within the map.
Table line_of_medians(const FragilitySurface& surface, const std::string& name) {
  Table table{.name = name + ", probability 0.5", .columns = {{"x", "x"}, {"y", "y"}}};
  const stats::SurfaceCoefficients c = surface.values();
  const double first = std::log(surface.map.front().y), last = std::log(surface.map.back().y);
  for (int i = 0; i <= points_of_a_law; ++i) {
    const double y = std::exp(first + (last - first) * i / points_of_a_law);
    const double v = std::log(y / surface.centre[1]);
    const double x = surface.centre[0] * std::exp(-(c[0] + c[2] * v) / (c[1] + c[3] * v));
    if (x >= surface.map.front().x && x <= surface.map.back().x) table.rows.push_back({x, y});
  }
  return table;
}

/// The tested points with the event in more than half of their realisations, or the other ones.
Table tested_table(const FragilitySurface& surface, bool in_most, const std::string& name) {
  Table table{.name = name,
              .columns = {{"x", "x"}, {"y", "y"}, {"n", "realisations"}, {"happened", "those with the event"}}};
  for (const TestedPoint& point : surface.tested) {
    const auto& [happened, trials] = std::pair(point.overturned.successes, point.overturned.trials);
    if ((2 * happened > trials) != in_most) continue;
    table.rows.push_back({point.x, point.y, trials, happened});
  }
  return table;
}

void add_panels(const FragilitySurface& surface, const std::string& title, Figure& figure) {
  const std::vector<Column> columns{{"x_from", "x, from"}, {"x_to", "x, to"}, {"y_from", "y, from"}, {"y_to", "y, to"}};
  const auto add_panel = [&](const std::string& words, const ShadedMap& map, const Shading& shading) {
    Panel& panel = figure.panels.emplace_back(Panel{.title = title + (title.empty() ? "" : ": ") + words,
                                                    .x = axis_of(surface.measures[0]),
                                                    .y = axis_of(surface.measures[1])});
    panel.x.low = map.x_edges.front();
    panel.x.high = map.x_edges.back();
    panel.y.low = map.y_edges.front();
    panel.y.high = map.y_edges.back();
    add_shades(map, shading, title + ' ' + words, figure);
  };
  const std::string event = probability_of(surface.subject.event);
  add_panel("probability of " + event, map_of(surface, [](const SurfacePoint& point) { return point.probability; }),
            {.quantity = "P", .columns = columns, .classes = probabilities});
  const std::string name = figure.panels.back().title;
  add_drawn(line_of_medians(surface, name),
            {.kind = LayerKind::line,
             .columns = {0, 1},
             .style = {.colour = "#d55e00", .width = 2.0, .size = 0.0},
             .legend = "P = 0.5"},
            figure);
  for (const bool in_most : {false, true}) {
    const std::string words = std::string("tested, event in ") + (in_most ? "more than half" : "at most half");
    add_drawn(tested_table(surface, in_most, name + ", " + words),
              {.kind = LayerKind::points,
               .columns = {0, 1},
               .style = {.colour = in_most ? "#d55e00" : "#000000", .size = 0.4},
               .legend = words},
              figure);
  }
  add_panel("width of its interval",
            map_of(surface,
                   [](const SurfacePoint& point) {
                     return point.interval ? point.interval->high - point.interval->low
                                           : std::numeric_limits<double>::quiet_NaN();
                   }),
            {.quantity = "width", .columns = columns, .classes = widths});
}

}  // namespace

std::optional<Figure> surface_figure(const FragilityReport& report) {
  Figure figure{.name = "surface", .title = "Probability over two measures of intensity"};
  for (const auto& [run, surface] : report.surfaces) {
    if (surface.outcome != stats::FragilityOutcome::fitted) continue;
    const std::string others = values_in_words(surface.subject.others);
    add_panels(surface, report.surfaces.size() > 1 ? run.title + (others.empty() ? "" : ", " + others) : "", figure);
    const auto& [x, y] = surface.measures;
    figure.description += (figure.description.empty() ? "" : "\n") + run.title + ", " +
                          probability_of(surface.subject.event) + ": median " + x;
    for (const SurfaceMedian& median : surface.medians) {
      figure.description += (median.x ? ' ' + significant(*median.x, 3) : " not known") + " at " + y + ' ' +
                            significant(median.y, 3) + ';';
    }
    if (surface.second->p_value)
      figure.description += " p of " + y + ' ' + significant(*surface.second->p_value, 2) + '.';
    if (figure.subtitle.empty()) figure.subtitle = run.title;
  }
  if (figure.panels.empty()) return std::nullopt;
  figure.caption =
      "Shades: the probability by the probit regression on the logarithms of both measures, and the width of its "
      "bootstrap interval over records; blank outside the convex hull of the tested points. Points: a record at a "
      "level, by the share of its realisations with the event.";
  return figure;
}

}  // namespace rocking::analysis
