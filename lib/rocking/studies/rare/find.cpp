#include "rocking/studies/rare/study.hpp"

#include <algorithm>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/rare/estimator.hpp"
#include "rocking/studies/rare/progress.hpp"
#include "rocking/studies/rare/rare.hpp"
#include "rocking/studies/rare/result.hpp"

namespace rocking {
void check_request(const Experiment& experiment, const RareRequest& request) {
  check_has_conditions(experiment);
  QuestionCheck check(request);
  check.expect(!request.seconds || request.elapsed_seconds, "seconds", "", "needs a clock: `elapsed_seconds`");
  check.expect(request.earlier.size() <= experiment.conditions.size(), "earlier",
               std::to_string(request.earlier.size()) + " entries", "must be at most one for each condition");
  for (std::size_t i = 0; i < request.earlier.size(); ++i) {
    const std::size_t size = request.earlier[i].repetitions.size();
    check.expect(size < rare::most_repetitions, "earlier/" + std::to_string(i), std::to_string(size) + " repetitions",
                 "must be fewer than " + std::to_string(rare::most_repetitions));
  }
  check.finish();
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
  if (found.size() > experiment.conditions.size()) {
    refuse("found", std::to_string(found.size()) + " estimates", "are those of an experiment with more conditions");
  }
  return rare_document().text(
      rare_report(experiment, {.question = request.question, .particles = request.particles}, found));
}

}  // namespace rocking
