#include "analysis/run_figures.hpp"

namespace rocking::analysis {

std::vector<Figure> run_figures(const Report& report, const Store* store) {
  std::vector<Figure> figures;
  const bool is_sweep = report.conditions.size() > 1;
  if (is_sweep) figures.push_back(mode_bands(report));
  if (report.most_realisations() > 1) figures.push_back(mode_probabilities(report));
  const auto add = [&figures](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  add(incidence_figure(report));
  if (is_sweep) {
    for (Figure& figure : quantile_figures(report)) figures.push_back(std::move(figure));
    add(non_recurrence(report));
    if (report.is_periodic()) add(divergence_quartiles(report));
  }
  if (store != nullptr && report.is_periodic()) add(divergence_times(report, *store));
  figures.push_back(scene_sketch(report));
  return figures;
}

}  // namespace rocking::analysis
