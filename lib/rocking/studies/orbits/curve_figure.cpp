#include "rocking/studies/orbits/study.hpp"

#include <utility>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"

namespace rocking::analysis {
namespace {

struct CurveLook {
  BifurcationKind kind;
  const char* legend;
  const char* colour;
  int dash;
};
constexpr std::array curve_looks{
    CurveLook{BifurcationKind::fold, "fold", "#1f4e79", 1},
    CurveLook{BifurcationKind::period_doubling, "period doubling", "#b03a2e", 2},
    CurveLook{BifurcationKind::symmetry_breaking, "symmetry breaking", "#2e7d32", 4},
};

Table plane_table(const OrbitStudy& study, const std::string& name) {
  const std::string& first = study.branches->pointer;
  const std::string& second = study.curves->pointers.front();
  return {.name = name,
          .columns = {{last_key(first), label_of(axis_of_parameter(first))},
                      {last_key(second), label_of(axis_of_parameter(second))},
                      {"period", "n of the orbits"},
                      {"curve", "its place"}},
          .rows = {}};
}

/// A row for a point of the curve at this place.
std::vector<Cell> row_of(const BifurcationPoint& point, const BifurcationCurve& curve, std::size_t place) {
  return {point.value, point.second_value, static_cast<double>(curve.orbits.period), static_cast<double>(place)};
}

/// The points of all curves of a kind, separated by empty rows.
Table lines_of(const OrbitStudy& study, const CurveLook& look) {
  Table table = plane_table(study, look.legend);
  const auto& curves = study.curves->curves;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].kind != look.kind) continue;
    for (const BifurcationPoint& point : curves[i].points) table.rows.push_back(row_of(point, curves[i], i));
    table.rows.push_back({Cell{}, Cell{}, Cell{}, Cell{}});
  }
  return table;
}

/// Where curves end because the changes of contact become others.
Table ends_of(const OrbitStudy& study) {
  Table table = plane_table(study, "change of contact");
  const auto& curves = study.curves->curves;
  const auto changes_contact = [](BranchEnd end) {
    return end == BranchEnd::grazing || end == BranchEnd::contact_change;
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (changes_contact(curves[i].ends[0])) table.rows.push_back(row_of(curves[i].points.front(), curves[i], i));
    if (changes_contact(curves[i].ends[1])) table.rows.push_back(row_of(curves[i].points.back(), curves[i], i));
  }
  return table;
}

}  // namespace

Figure curve_figure(const OrbitsReport& report) {
  const FoundBranches& branches = *report.study.branches;
  const FoundCurves& curves = *report.study.curves;
  Figure figure;
  figure.name = "curves";
  figure.title = "Bifurcations of periodic orbits";
  figure.subtitle = report.input.title();
  figure.arrangement = Arrangement::stacked;
  figure.panels.push_back({.title = "",
                           .x = axis_of_parameter(branches.pointer),
                           .y = axis_of_parameter(curves.pointers.front()),
                           .layers = {},
                           .height = 1.6});
  Panel& panel = figure.panels.back();
  panel.x.low = branches.range.low;
  panel.x.high = branches.range.high;
  panel.y.low = curves.range.low;
  panel.y.high = curves.range.high;
  for (const CurveLook& look : curve_looks) {
    add_layer(lines_of(report.study, look), LayerKind::line,
              {.colour = look.colour, .dash = look.dash, .marker = 0, .width = 1.8}, look.legend, figure);
  }
  add_layer(ends_of(report.study), LayerKind::points, {.colour = "#000000", .marker = 2, .size = 0.9},
            "change of contact", figure);
  figure.caption =
      "On each curve a periodic orbit loses its stability or ceases to exist. Curves end at the edges, or where the "
      "contacts of the orbit change.";
  return figure;
}

}  // namespace rocking::analysis
