#include "analysis/curve_figure.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/output_file.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/parameter_names.hpp"

namespace rocking::analysis {
namespace {

struct CurveLook {
  std::string_view kind;
  std::string_view legend;
  const char* colour;
  int dash;
};
constexpr std::array curve_looks{CurveLook{"fold", "fold", "#1f4e79", 1},
                                 CurveLook{"period_doubling", "period doubling", "#b03a2e", 2},
                                 CurveLook{"symmetry_breaking", "symmetry breaking", "#2e7d32", 4}};

std::string second_pointer(const Json& output) { return output.at("second_parameter").at(0); }

Table plane_table(const Json& output, std::string_view name) {
  const std::string first = output.at("parameter");
  const std::string second = second_pointer(output);
  return {.name = std::string(name),
          .columns = {{last_key(first), label_of(axis_of_parameter(first))},
                      {last_key(second), label_of(axis_of_parameter(second))},
                      {"period", "n of the orbits"},
                      {"curve", "its place"}},
          .rows = {}};
}

/// The points of all curves of a kind, separated by empty rows.
Table lines_of(const Json& output, const CurveLook& look) {
  Table table = plane_table(output, look.legend);
  double place = 0.0;
  for (const Json& curve : output.at("curves")) {
    if (curve.at("kind").get<std::string>() == look.kind) {
      for (const Json& point : curve.at("points")) {
        table.rows.push_back({point.at("value").get<double>(), point.at("second_value").get<double>(),
                              curve.at("period").get<double>(), place});
      }
      table.rows.push_back({Cell{}, Cell{}, Cell{}, Cell{}});
    }
    ++place;
  }
  return table;
}

/// Where curves end because the changes of contact become others.
Table ends_of(const Json& output) {
  Table table = plane_table(output, "change of contact");
  double place = 0.0;
  for (const Json& curve : output.at("curves")) {
    const Json& points = curve.at("points");
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::string why = curve.at("ends").at(end);
      if (why != "grazing" && why != "contact_change") continue;
      const Json& point = end == 0 ? points.front() : points.back();
      table.rows.push_back({point.at("value").get<double>(), point.at("second_value").get<double>(),
                            curve.at("period").get<double>(), place});
    }
    ++place;
  }
  return table;
}

void add_to(Figure& figure, Table table, LayerKind kind, const Style& style, const std::string& legend) {
  if (table.rows.empty()) return;
  figure.panels.back().layers.push_back(
      {.kind = kind, .table = figure.tables.size(), .columns = {0, 1}, .style = style, .legend = legend});
  figure.tables.push_back(std::move(table));
}

}  // namespace

bool has_curves(const Json& output) { return output.contains("curves") && !output.at("curves").empty(); }

Figure curve_figure(const Json& output) {
  Figure figure;
  read_or_refuse(output, [&] {
    figure.name = "curves";
    figure.title = "Bifurcations of periodic orbits";
    figure.subtitle = output.at("input").at("experiment").at("title");
    figure.arrangement = Arrangement::stacked;
    figure.panels.push_back({.title = "",
                             .x = axis_of_parameter(output.at("parameter")),
                             .y = axis_of_parameter(second_pointer(output)),
                             .layers = {},
                             .height = 1.6});
    Panel& panel = figure.panels.back();
    panel.x.low = output.at("range").at(0);
    panel.x.high = output.at("range").at(1);
    panel.y.low = output.at("second_range").at(0);
    panel.y.high = output.at("second_range").at(1);
    for (const CurveLook& look : curve_looks) {
      add_to(figure, lines_of(output, look), LayerKind::line,
             {.colour = look.colour, .dash = look.dash, .marker = 0, .width = 1.8}, std::string(look.legend));
    }
    add_to(figure, ends_of(output), LayerKind::points, {.colour = "#000000", .marker = 2, .size = 0.9},
           "change of contact");
    figure.caption =
        "On each curve a periodic orbit loses its stability or ceases to exist. Curves end at the edges, or where the "
        "contacts of the orbit change.";
  });
  return figure;
}

}  // namespace rocking::analysis
