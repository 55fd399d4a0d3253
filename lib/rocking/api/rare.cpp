#include "rocking/api/studies.hpp"

#include <algorithm>

#include "rocking/api/rare_progress.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/output/rare_report.hpp"
#include "rocking/studies/rare/rare.hpp"

namespace rocking {
void check_request(const Experiment& experiment, const RareRequest& request) {
  if (request.particles < 20 || request.particles > 100'000) {
    refuse("particles", std::to_string(request.particles), "must be a whole number from 20 to 100000");
  }
  const double error = request.question.relative_error;
  if (!(error >= 1e-3 && error <= 1.0)) refuse("relative_error", base::shortest(error), "must be from 1e-3 to 1");
  if (request.seconds && !(*request.seconds > 0.0 && request.elapsed_seconds)) {
    refuse("seconds", base::shortest(*request.seconds), "must be positive, and needs a clock");
  }
  const auto tilt = request.question.event.peak_tilt;
  if (tilt && !(*tilt >= 0.0 && *tilt <= 100.0)) refuse("peak_tilt", base::shortest(*tilt), "must be from 0 to 100");
  check_rare(experiment);
}

std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareRequest& request,
                                             const Execution& execution) {
  check_request(experiment, request);
  const OptionsOfExecution asked(execution);
  TotalProgress progress(asked.options(), experiment.conditions.size());
  RareSettings settings{.particles = request.particles, .threads = asked.options().threads, .stop = asked.stop()};
  settings.seconds = request.seconds;
  settings.elapsed_seconds = request.elapsed_seconds;
  settings.on_progress = [&progress](std::size_t condition, double done, double expected) {
    progress.tell(condition, done, expected);
  };
  settings.earlier = request.earlier;
  settings.keep = request.keep;
  std::vector<RareEstimate> found = rare_probabilities(experiment, request.question, settings);
  const bool is_stopped = std::ranges::any_of(found, [](const auto& one) { return one.end == RareEnd::stopped; });
  if (is_stopped && !request.keeps_when_stopped) throw base::Stopped();
  return found;
}

std::string rare_probabilities_text(const Experiment& experiment, const RareRequest& request,
                                    const std::vector<RareEstimate>& found) {
  return rare_document().text(
      rare_report(experiment, {.question = request.question, .particles = request.particles}, found));
}

}  // namespace rocking
