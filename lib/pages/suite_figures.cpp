#include "pages/suite_figures.hpp"

#include <algorithm>
#include <utility>

#include "analysis/fragility_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/write_fragility.hpp"
#include "rocking/studies/run_fragility.hpp"

namespace rocking::pages {

std::vector<analysis::Figure> suite_figures(const Experiment& experiment, const Store& store, unsigned threads) {
  if (intensity_of(experiment).empty() || experiment.conditions.front().until) return {};
  const FragilityQuestion question{.incremental = true};
  RunOptions options;
  options.threads = threads;
  const RunFragility run = run_fragility(experiment, stripes_of(experiment, store), question, options);
  if (run.suites.empty()) return {};
  const Json output = Json::parse(fragility_text({run}));
  std::vector<analysis::Figure> figures = analysis::fragility_figures(output);
  for (analysis::Figure& figure : analysis::incremental_figures(output)) figures.push_back(std::move(figure));
  return figures;
}

bool is_suite(const std::vector<std::string>& swept) {
  return std::ranges::find(swept, "/excitation/file") != swept.end();
}

}  // namespace rocking::pages
