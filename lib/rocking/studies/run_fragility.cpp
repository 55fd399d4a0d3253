#include "rocking/studies/run_fragility.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

/// Throws where the header of the hazard curve names another intensity measure than that of the run.
void check_intensity(const HazardCurve& hazard, std::string_view parameter) {
  const std::string own(parameter.substr(parameter.rfind('/') + 1));
  if (hazard.intensity.empty() || hazard.intensity == own || hazard.intensity == parameter) return;
  throw base::InputError({.place = hazard.name + ", line " + std::to_string(hazard.header_line),
                          .value = hazard.intensity,
                          .reason = "is not the intensity measure of the run, which is " + own,
                          .remedy = "give a hazard curve in " + own + " with the header \"" + own +
                                    ", annual_rate\", or a run that sweeps " + hazard.intensity,
                          .where = {}});
}

void add_group(const StripeGroup& group, const FragilityQuestion& question, RunFragility& run) {
  std::vector<FragilityEvent> events(1);  // overturning
  for (const double tilt : question.peak_tilts) events.push_back({.peak_tilt = tilt});
  for (const FragilityEvent& event : events) {
    if (group.is_suite()) {
      ShownSuite& shown = run.suites.emplace_back(ShownSuite{.curve = suite_curve(group, event, run.experiment.seed)});
      shown.has_hazard = question.hazard.has_value();
      if (question.hazard) shown.rate = annual_rate(shown.curve, *question.hazard);
    } else {
      ShownCurve& shown = run.curves.emplace_back(ShownCurve{.curve = fragility(group, event, run.experiment.seed)});
      if (question.hazard) shown.rate = annual_rate(shown.curve, *question.hazard);
    }
  }
  if (question.incremental) run.incremental.push_back(incremental_analysis(group));
}

}  // namespace

bool needs_peak_tilts(const FragilityQuestion& question) {
  return !question.peak_tilts.empty() || question.incremental;
}

RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& groups,
                           const FragilityQuestion& question) {
  if (question.hazard) check_intensity(*question.hazard, intensity_of(experiment));
  RunFragility run{.experiment = experiment};
  for (const StripeGroup& group : groups) add_group(group, question, run);
  return run;
}

}  // namespace rocking
