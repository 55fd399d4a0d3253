#include "pages/suite_figures.hpp"

#include <algorithm>
#include <utility>

#include "analysis/fragility_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/fragility_report.hpp"
#include "rocking/studies/run_fragility.hpp"

namespace rocking::pages {

std::vector<analysis::Figure> suite_figures(const Experiment& experiment, const Store& store, unsigned threads,
                                            const std::optional<HazardCurve>& hazard) {
  if (intensity_of(experiment).empty() || experiment.conditions.front().until) return {};
  const FragilityQuestion question{.hazard = hazard, .incremental = true};
  RunOptions options;
  options.threads = threads;
  const RunFragility run = run_fragility(experiment, stripes_of(experiment, store), question, options);
  if (run.suites.empty()) return {};
  const FragilityReport report = fragility_report({run});
  std::vector<analysis::Figure> figures{analysis::fragility_figure(report)};
  if (auto figure = analysis::incremental_figure(report)) figures.push_back(std::move(*figure));
  return figures;
}

bool is_suite(const std::vector<std::string>& swept) {
  return std::ranges::find(swept, "/excitation/file") != swept.end();
}

}  // namespace rocking::pages
