#include "rocking/studies/rare/study.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/shaded_map.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_panels = 6;

constexpr std::array<ShadeClass, 7> classes{{{0.5, "0.5 to 1"},
                                             {0.1, "0.1 to 0.5"},
                                             {1e-2, "0.01 to 0.1"},
                                             {1e-3, "1e-3 to 0.01"},
                                             {1e-4, "1e-4 to 1e-3"},
                                             {1e-5, "1e-5 to 1e-4"},
                                             {1e-6, "1e-6 to 1e-5"}}};

std::string title_of(const ReportedRare& condition) {
  std::string title = values_of(condition.parameters);
  const auto probability = condition.estimate.probability;
  if (probability) title += (title.empty() ? "" : ": ") + ("probability " + significant(*probability, 3));
  return title;
}

/// Of `points` on equal distances from -reach to reach, the first and last cells are half as wide.
std::vector<double> edges(double reach, std::size_t points) {
  const auto steps = static_cast<double>(points - 1);
  std::vector<double> found;
  for (std::size_t i = 0; i <= points; ++i) {
    found.push_back(reach * std::clamp((2.0 * static_cast<double>(i) - 1.0) / steps - 1.0, -1.0, 1.0));
  }
  return found;
}

void add_committor(const rare::CommittorMap& map, const std::string& name, Figure& figure) {
  if (map.rows.size() < 2) return;
  add_shades(
      {.x_edges = edges(map.tilt, map.rows.front().size()),
       .y_edges = edges(map.tilt_rate, map.rows.size()),
       .numbers = map.rows},
      {.quantity = "probability",
       .columns = {{"tilt_from", "Θ, from"}, {"tilt_to", "Θ, to"}, {"rate_from", "Θ′, from"}, {"rate_to", "Θ′, to"}},
       .classes = classes},
      name, figure);
}

/// Those within the map.
Table strobe_points(const ReportedRare& condition, const rare::CommittorMap& map, const std::string& name) {
  Table table{.name = name + ", strobe points of paths", .columns = {{"tilt", "Θ"}, {"tilt_rate", "Θ′"}}};
  for (const rare::Path& path : condition.estimate.paths) {
    for (const rare::StrobeState& state : path.strobe) {
      if (std::abs(state.tilt) > map.tilt || std::abs(state.tilt_rate) > map.tilt_rate) continue;
      table.rows.push_back({state.tilt, state.tilt_rate});
    }
  }
  return table;
}

Figure committor_figure(const RareReport& report, const std::vector<const ReportedRare*>& conditions) {
  Figure figure{.name = "rare_committor", .title = "From where is the event likely?", .subtitle = report.input.title()};
  for (const ReportedRare* condition : conditions) {
    const rare::CommittorMap& map = *condition->estimate.committor;
    const std::string title = title_of(*condition);
    figure.panels.push_back(
        {.title = title,
         .x = {.quantity = "tilt at the strobe", .symbol = "Θ", .low = -map.tilt, .high = map.tilt},
         .y = {.quantity = "tilt rate", .symbol = "Θ′", .low = -map.tilt_rate, .high = map.tilt_rate}});
    add_committor(map, title, figure);
    add_drawn(strobe_points(*condition, map, title),
              {.kind = LayerKind::points,
               .style = {.colour = "#d55e00", .size = 0.4},
               .legend = "strobe points of paths to the event"},
              figure);
  }
  figure.caption = "Committor: estimate of the probability to " + to_do(report.question.event) +
                   " from a point (Θ, Θ′) of the Poincaré section at strobe point 1, with all of the horizon ahead, "
                   "without slip. White: below 1e-6. Points: the paths of the figure below, while they are within it.";
  return figure;
}

/// Until it falls.
Table tilt_table(const rare::Path& path, const std::string& name) {
  constexpr double falling = 1.5;
  Table table{.name = name, .columns = {{"time", "time since the start [excitation periods]"}, {"tilt", "Θ"}}};
  double sample = 0.0;
  for (const std::vector<double>& period : path.tilts) {
    for (const double tilt : period) {
      table.rows.push_back({sample / path.samples_per_period, tilt});
      if (std::abs(tilt) > falling) return table;
      sample += 1.0;
    }
  }
  return table;
}

Figure path_figure(const RareReport& report, const std::vector<const ReportedRare*>& conditions) {
  Figure figure{.name = "rare_paths",
                .title = "Paths to the event",
                .subtitle = report.input.title(),
                .arrangement = Arrangement::stacked};
  double end = 0.0;
  for (const ReportedRare* condition : conditions) {
    figure.panels.push_back({.title = title_of(*condition),
                             .x = {.quantity = "time", .unit = "excitation periods", .low = 0.0},
                             .y = {.quantity = "tilt", .symbol = "Θ", .low = -1.6, .high = 1.6}});
    std::size_t number = 0;
    for (const rare::Path& path : condition->estimate.paths) {
      Style style = style_of_curve(number++);
      style.marker = 0;
      style.width = 1.2;
      const std::string name = "path " + std::to_string(number);
      Table table = tilt_table(path, figure.panels.back().title + ", " + name);
      if (!table.rows.empty()) end = std::max(end, std::get<double>(table.rows.back().front()));
      add_drawn(std::move(table), {.kind = LayerKind::line, .style = style, .legend = name}, figure);
    }
  }
  for (Panel& panel : figure.panels) panel.x.high = end;
  figure.caption = "Tilt Θ = θ/ψ, over ψ of its side, of paths that " + to_do(report.question.event) +
                   ", drawn from those of two repetitions by their weights, up to |Θ| = 1.5. At |Θ| = 1 a block at "
                   "rest would be in unstable equilibrium.";
  return figure;
}

/// The first ones of which `has` is true.
template <class Has>
std::vector<const ReportedRare*> some(const RareReport& report, Has&& has) {
  std::vector<const ReportedRare*> found;
  for (const ReportedRare& condition : report.conditions) {
    if (found.size() < most_panels && has(condition.estimate)) found.push_back(&condition);
  }
  return found;
}

}  // namespace

std::vector<Figure> rare_figures(const RareReport& report) {
  std::vector<Figure> figures;
  const auto with_map = some(report, [](const RareEstimate& found) { return found.committor.has_value(); });
  const auto with_paths = some(report, [](const RareEstimate& found) { return !found.paths.empty(); });
  if (!with_map.empty()) figures.push_back(committor_figure(report, with_map));
  if (!with_paths.empty()) figures.push_back(path_figure(report, with_paths));
  return figures;
}

}  // namespace rocking::analysis
