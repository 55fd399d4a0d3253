#include "analysis/rare_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "analysis/palette.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_panels = 6;

/// Probabilities from `least` on, up to the class before.
struct Class {
  double least;
  const char* words;
  const char* colour;
};
constexpr std::array<Class, 7> classes{{{0.5, "0.5 to 1", "#08306b"},
                                        {0.1, "0.1 to 0.5", "#08519c"},
                                        {1e-2, "0.01 to 0.1", "#2171b5"},
                                        {1e-3, "1e-3 to 0.01", "#4292c6"},
                                        {1e-4, "1e-4 to 1e-3", "#6baed6"},
                                        {1e-5, "1e-5 to 1e-4", "#9ecae1"},
                                        {1e-6, "1e-6 to 1e-5", "#c6dbef"}}};

/// The number of classes: none.
std::size_t class_of(double probability) {
  const auto found = std::ranges::find_if(classes, [&](const Class& each) { return probability >= each.least; });
  return static_cast<std::size_t>(found - classes.begin());
}

std::string event_words(const RareQuestion& question) {
  return question.event.peak_tilt ? "reach |Θ| = " + number_text(*question.event.peak_tilt) : std::string("overturn");
}

std::string title_of(const ReportedRare& condition) {
  std::string title;
  for (const Parameter& parameter : condition.parameters) {
    title += (title.empty() ? "" : ", ") + parameter.pointer.substr(parameter.pointer.rfind('/') + 1) + ' ' +
             short_value(parameter);
  }
  const auto probability = condition.estimate.probability;
  if (probability) title += (title.empty() ? "" : ": ") + ("probability " + significant(*probability, 3));
  return title;
}

/// The cells of a class as boxes, neighbours in a row as one.
Table cells_of(const rare::CommittorMap& map, std::size_t wanted, const std::string& name) {
  Table table{
      .name = name + ", " + classes.at(wanted).words,
      .columns = {{"tilt_from", "Θ, from"}, {"tilt_to", "Θ, to"}, {"rate_from", "Θ′, from"}, {"rate_to", "Θ′, to"}},
      .rows = {}};
  if (map.rows.size() < 2) return table;
  const auto steps_down = static_cast<double>(map.rows.size() - 1);
  const auto steps_right = static_cast<double>(map.rows.front().size() - 1);
  const auto edge = [](double reach, double steps, std::size_t i) {
    return reach * std::clamp((2.0 * static_cast<double>(i) - 1.0) / steps - 1.0, -1.0, 1.0);
  };
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    const auto& numbers = map.rows[row];
    for (std::size_t from = 0; from < numbers.size();) {
      std::size_t to = from;
      while (to < numbers.size() && class_of(numbers[to]) == class_of(numbers[from])) ++to;
      if (class_of(numbers[from]) == wanted) {
        table.rows.push_back({edge(map.tilt, steps_right, from), edge(map.tilt, steps_right, to),
                              edge(map.tilt_rate, steps_down, row), edge(map.tilt_rate, steps_down, row + 1)});
      }
      from = to;
    }
  }
  return table;
}

/// Those within the map.
Table strobe_points(const ReportedRare& condition, const rare::CommittorMap& map, const std::string& name) {
  Table table{.name = name + ", strobe points of paths", .columns = {{"tilt", "Θ"}, {"tilt_rate", "Θ′"}}, .rows = {}};
  for (const rare::Path& path : condition.estimate.paths) {
    for (const rare::StrobeState& state : path.strobe) {
      if (std::abs(state.tilt) > map.tilt || std::abs(state.tilt_rate) > map.tilt_rate) continue;
      table.rows.push_back({state.tilt, state.tilt_rate});
    }
  }
  return table;
}

/// Adds a table and a layer of it to the last panel, unless the table has no rows. Its numbers are those of rare.json.
void add(Table table, Layer layer, Figure& figure) {
  if (table.rows.empty()) return;
  table.only_drawn = true;
  layer.table = figure.tables.size();
  figure.tables.push_back(std::move(table));
  figure.panels.back().layers.push_back(std::move(layer));
}

Figure committor_figure(const RareReport& report, const std::vector<const ReportedRare*>& conditions) {
  Figure figure;
  figure.name = "rare_committor";
  figure.title = "From where is the event likely?";
  figure.subtitle = report.input.title();
  for (const ReportedRare* condition : conditions) {
    const rare::CommittorMap& map = *condition->estimate.committor;
    const std::string title = title_of(*condition);
    figure.panels.push_back(
        {.title = title,
         .x = {.quantity = "tilt at the strobe", .symbol = "Θ", .unit = "", .low = -map.tilt, .high = map.tilt},
         .y = {.quantity = "tilt rate", .symbol = "Θ′", .unit = "", .low = -map.tilt_rate, .high = map.tilt_rate},
         .layers = {}});
    for (std::size_t i = 0; i < classes.size(); ++i) {
      add(cells_of(map, i, title),
          {.kind = LayerKind::boxes,
           .columns = {0, 1, 2, 3},
           .style = {.colour = classes.at(i).colour},
           .legend = std::string("probability ") + classes.at(i).words},
          figure);
    }
    add(strobe_points(*condition, map, title),
        {.kind = LayerKind::points,
         .columns = {0, 1},
         .style = {.colour = "#d55e00", .size = 0.4},
         .legend = "strobe points of paths to the event"},
        figure);
  }
  figure.caption = "Committor: estimate of the probability to " + event_words(report.question) +
                   " from a point (Θ, Θ′) of the Poincaré section at strobe point 1, with all of the horizon ahead, "
                   "without slip. White: below 1e-6. Points: the paths of the figure below, while they are within it.";
  return figure;
}

/// Until it falls.
Table tilt_table(const rare::Path& path, const std::string& name) {
  constexpr double falling = 1.5;
  Table table{
      .name = name, .columns = {{"time", "time since the start [excitation periods]"}, {"tilt", "Θ"}}, .rows = {}};
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
  Figure figure;
  figure.name = "rare_paths";
  figure.title = "Paths to the event";
  figure.subtitle = report.input.title();
  figure.arrangement = Arrangement::stacked;
  double end = 0.0;
  for (const ReportedRare* condition : conditions) {
    figure.panels.push_back({.title = title_of(*condition),
                             .x = {.quantity = "time", .symbol = "", .unit = "excitation periods", .low = 0.0},
                             .y = {.quantity = "tilt", .symbol = "Θ", .unit = "", .low = -1.6, .high = 1.6},
                             .layers = {}});
    std::size_t number = 0;
    for (const rare::Path& path : condition->estimate.paths) {
      Style style = style_of_curve(number++);
      style.marker = 0;
      style.width = 1.2;
      const std::string name = "path " + std::to_string(number);
      Table table = tilt_table(path, figure.panels.back().title + ", " + name);
      if (!table.rows.empty()) end = std::max(end, std::get<double>(table.rows.back().front()));
      add(std::move(table), {.kind = LayerKind::line, .columns = {0, 1}, .style = style, .legend = name}, figure);
    }
  }
  for (Panel& panel : figure.panels) panel.x.high = end;
  figure.caption = "Tilt Θ = θ/ψ of paths that " + event_words(report.question) +
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
