#include "rocking/studies/motion/study.hpp"

#include <array>

#include "rocking/figures/palette.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// A panel of a motion against time: the column of its table, and its axis.
struct SeriesPanel {
  std::vector<double> MotionSeries::*numbers;
  const char* key;
  const char* quantity;
  const char* unit;
};
constexpr std::array<SeriesPanel, 3> series_panels{
    {{&MotionSeries::acceleration_g, "acceleration_g", "acceleration", "g"},
     {&MotionSeries::velocity_m_s, "velocity_m_s", "velocity", "m/s"},
     {&MotionSeries::displacement_m, "displacement_m", "displacement", "m"}}};

/// A panel of the spectra, likewise.
struct SpectrumPanel {
  double SpectralPoint::*number;
  const char* key;
  const char* quantity;
  const char* unit;
};
constexpr std::array<SpectrumPanel, 2> spectrum_panels{
    {{&SpectralPoint::sa_g, "sa_g", "spectral pseudo-acceleration", "g"},
     {&SpectralPoint::sv_m_s, "sv_m_s", "spectral velocity", "m/s"}}};

Table series_table(const ReportedMotion& motion) {
  Table table{.name = motion.facts.file, .columns = {{"time_s", "time [s]"}}, .rows = {}};
  for (const SeriesPanel& panel : series_panels) {
    table.columns.push_back({panel.key, std::string(panel.quantity) + " of the base [" + panel.unit + ']'});
  }
  for (std::size_t i = 0; i < motion.series->time_s.size(); ++i) {
    table.rows.push_back({motion.series->time_s[i]});
    for (const SeriesPanel& panel : series_panels) {
      table.rows.back().emplace_back((*motion.series.*panel.numbers)[i]);
    }
  }
  return table;
}

std::string measures_in_words(const IntensityMeasures& of) {
  return "PGA " + significant(of.pga_g, 3) + " g, PGV " + significant(of.pgv_m_s, 3) + " m/s, PGD " +
         significant(of.pgd_m, 3) + " m, Arias intensity " + significant(of.arias_m_s, 3) +
         " m/s, significant duration " + significant(of.significant_to_s - of.significant_from_s, 3) + " s";
}

Figure time_figure(const ReportedMotion& motion) {
  Figure figure;
  figure.name = "ground_motion";
  figure.title = "Ground motion";
  figure.subtitle = motion.facts.file;
  figure.caption = measures_in_words(motion.measures) +
                   ". Velocity and displacement are the integrals of the acceleration as it is, from rest: nothing is "
                   "filtered, and no baseline is corrected.";
  figure.description = "Acceleration, velocity and displacement of " + motion.facts.file +
                       " against time: " + measures_in_words(motion.measures) + '.';
  figure.arrangement = Arrangement::stacked;
  figure.tables.push_back(series_table(motion));
  Style style = style_of_curve(0);
  style.width = 0.8;
  style.size = 0.0;
  for (const SeriesPanel& panel : series_panels) {
    figure.panels.push_back({.title = "",
                             .x = {.quantity = "time", .symbol = "t", .unit = "s"},
                             .y = {.quantity = panel.quantity, .symbol = "", .unit = panel.unit},
                             .layers = {}});
    draw({.kind = LayerKind::line, .style = style}, {"time_s", panel.key}, figure);
  }
  return figure;
}

Table spectrum_table(const ReportedMotion& motion) {
  Table table{.name = motion.facts.file, .columns = {{"period_s", "period of the oscillator [s]"}}, .rows = {}};
  for (const SpectrumPanel& panel : spectrum_panels) {
    table.columns.push_back({panel.key, std::string(panel.quantity) + " [" + panel.unit + ']'});
  }
  for (const SpectralPoint& entry : motion.series->spectrum) {
    table.rows.push_back({entry.period_s});
    for (const SpectrumPanel& panel : spectrum_panels) table.rows.back().emplace_back(entry.*panel.number);
  }
  return table;
}

Figure spectra_figure(const MotionReport& report) {
  Figure figure;
  figure.name = "response_spectra";
  figure.title = "Response spectra";
  const std::string damping = significant(100.0 * report.damping, 3) + " % damping";
  figure.subtitle = damping;
  figure.caption =
      "Pseudo-acceleration (omega^2 times the largest displacement relative to the base) and largest velocity relative "
      "to the base of a linear oscillator with " +
      damping + ", wherever they are reached.";
  figure.description = "Spectral pseudo-acceleration and velocity against the period of the oscillator.";
  for (const SpectrumPanel& panel : spectrum_panels) {
    figure.panels.push_back({.title = "",
                             .x = {.quantity = "period", .symbol = "T", .unit = "s", .logarithmic = true},
                             .y = {.quantity = panel.quantity, .symbol = "", .unit = panel.unit, .low = 0.0},
                             .layers = {}});
  }
  for (const ReportedMotion& motion : report.motions) {
    if (!motion.series) continue;
    Style style = style_of_curve(figure.tables.size());
    style.size = 0.0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      figure.panels[i].layers.push_back({.kind = LayerKind::line,
                                         .table = figure.tables.size(),
                                         .columns = {0, i + 1},
                                         .style = style,
                                         .legend = motion.facts.file});
    }
    figure.tables.push_back(spectrum_table(motion));
  }
  return figure;
}

}  // namespace

std::vector<Figure> motion_figures(const MotionReport& report) {
  std::vector<Figure> figures;
  for (const ReportedMotion& motion : report.motions) {
    if (motion.series) figures.push_back(time_figure(motion));
  }
  if (!figures.empty()) figures.push_back(spectra_figure(report));
  return figures;
}

}  // namespace rocking::analysis
