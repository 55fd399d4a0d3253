#include "analysis/motion_figure.hpp"

#include <array>
#include <string>
#include <utility>

#include "analysis/output_file.hpp"
#include "analysis/palette.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// A panel of a motion against time: its key in the series, and its axis.
struct SeriesPanel {
  const char* key;
  const char* quantity;
  const char* unit;
};
constexpr std::array<SeriesPanel, 3> series_panels{{{"acceleration_g", "acceleration", "g"},
                                                    {"velocity_m_s", "velocity", "m/s"},
                                                    {"displacement_m", "displacement", "m"}}};

/// A panel of the spectra: the key of a point, and its axis.
constexpr std::array<SeriesPanel, 2> spectrum_panels{
    {{"sa_g", "spectral acceleration", "g"}, {"sv_m_s", "spectral velocity", "m/s"}}};

bool has_series(const Json& motion) { return motion.contains("series"); }

Table series_table(const Json& motion) {
  Table table{.name = motion.at("file"), .columns = {{"time_s", "time [s]"}}, .rows = {}};
  for (const SeriesPanel& panel : series_panels) {
    table.columns.push_back({panel.key, std::string(panel.quantity) + " of the base [" + panel.unit + ']'});
  }
  const Json& series = motion.at("series");
  const Json& times = series.at("time_s");
  for (std::size_t i = 0; i < times.size(); ++i) {
    table.rows.push_back({times.at(i).get<double>()});
    for (const SeriesPanel& panel : series_panels)
      table.rows.back().emplace_back(series.at(panel.key).at(i).get<double>());
  }
  return table;
}

std::string measures_in_words(const Json& motion) {
  return "PGA " + significant(motion.at("pga_g"), 3) + " g, PGV " + significant(motion.at("pgv_m_s"), 3) +
         " m/s, PGD " + significant(motion.at("pgd_m"), 3) + " m, Arias intensity " +
         significant(motion.at("arias_m_s"), 3) + " m/s, significant duration " +
         significant(motion.at("significant_duration_s"), 3) + " s";
}

Figure time_figure(const Json& motion) {
  Figure figure;
  figure.name = "ground_motion";
  figure.title = "Ground motion";
  figure.subtitle = motion.at("file");
  figure.caption = measures_in_words(motion) +
                   ". Velocity and displacement are the integrals of the acceleration as it is, from rest: nothing is "
                   "filtered, and no baseline is corrected.";
  figure.description = "Acceleration, velocity and displacement of " + motion.at("file").get<std::string>() +
                       " against time: " + measures_in_words(motion) + '.';
  figure.arrangement = Arrangement::stacked;
  figure.tables.push_back(series_table(motion));
  Style style = style_of_curve(0);
  style.width = 0.8;
  style.size = 0.0;
  for (std::size_t i = 0; i < series_panels.size(); ++i) {
    const SeriesPanel& panel = series_panels[i];
    figure.panels.push_back({.title = "",
                             .x = {.quantity = "time", .symbol = "t", .unit = "s"},
                             .y = {.quantity = panel.quantity, .symbol = "", .unit = panel.unit},
                             .layers = {{.kind = LayerKind::line, .columns = {0, i + 1}, .style = style}}});
  }
  return figure;
}

Table spectrum_table(const Json& motion) {
  Table table{.name = motion.at("file"), .columns = {{"period_s", "period of the oscillator [s]"}}, .rows = {}};
  for (const SeriesPanel& panel : spectrum_panels) {
    table.columns.push_back({panel.key, std::string(panel.quantity) + " [" + panel.unit + ']'});
  }
  for (const Json& point : motion.at("series").at("spectrum")) {
    table.rows.push_back({point.at("period_s").get<double>()});
    for (const SeriesPanel& panel : spectrum_panels) table.rows.back().emplace_back(point.at(panel.key).get<double>());
  }
  return table;
}

Figure spectra_figure(const Json& output) {
  Figure figure;
  figure.name = "response_spectra";
  figure.title = "Response spectra";
  const std::string damping = significant(100.0 * output.at("damping").get<double>(), 3) + " % damping";
  figure.subtitle = damping;
  figure.caption =
      "Largest absolute acceleration and largest velocity relative to the base of a linear oscillator with " + damping +
      ", wherever they are reached.";
  figure.description = "Spectral acceleration and velocity against the period of the oscillator.";
  for (const SeriesPanel& panel : spectrum_panels) {
    figure.panels.push_back({.title = "",
                             .x = {.quantity = "period", .symbol = "T", .unit = "s", .logarithmic = true},
                             .y = {.quantity = panel.quantity, .symbol = "", .unit = panel.unit, .low = 0.0},
                             .layers = {}});
  }
  for (const Json& motion : output.at("motions")) {
    if (!has_series(motion)) continue;
    Style style = style_of_curve(figure.tables.size());
    style.size = 0.0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      figure.panels[i].layers.push_back({.kind = LayerKind::line,
                                         .table = figure.tables.size(),
                                         .columns = {0, i + 1},
                                         .style = style,
                                         .legend = motion.at("file")});
    }
    figure.tables.push_back(spectrum_table(motion));
  }
  return figure;
}

}  // namespace

std::vector<Figure> motion_figures(const Json& output) {
  std::vector<Figure> figures;
  read_or_refuse(output, [&] {
    for (const Json& motion : output.at("motions")) {
      if (has_series(motion)) figures.push_back(time_figure(motion));
    }
    if (!figures.empty()) figures.push_back(spectra_figure(output));
  });
  return figures;
}

}  // namespace rocking::analysis
