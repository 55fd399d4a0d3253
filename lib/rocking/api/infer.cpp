#include <algorithm>
#include <filesystem>
#include <utility>

#include "rocking/api/infer.hpp"
#include "rocking/api/infer_simulation.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/read_tests.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/output/infer_report.hpp"
#include "rocking/studies/infer/infer.hpp"
#include "rocking/text/files.hpp"

namespace rocking {

CountedTests counted_tests(const Experiment& experiment, const std::filesystem::path& tests,
                           const std::optional<std::filesystem::path>& candidates,
                           const std::filesystem::path& folder) {
  CountedTests read = read_tests(read_file(tests, most_tests_bytes + 1), tests.string(), experiment, folder);
  if (candidates) {
    read_candidates(read_file(*candidates, most_tests_bytes + 1), candidates->string(), experiment, folder, read);
  }
  return read;
}

void check_infer(const Experiment& experiment) {
  if (experiment.unknowns.empty()) {
    throw base::InputError({"/unknown", "", "is missing: there is nothing to infer",
                            "add for example \"unknown\": [{\"parameter\": \"/friction/static\", \"from\": 0.2, "
                            "\"to\": 0.6}]"});
  }
  const Condition& first = experiment.conditions.front();
  if (first.until) {
    throw base::InputError(
        {"/realisations", "", "depends on intervals, but every point of a design has as many", "give a fixed number"});
  }
  if (std::ranges::any_of(first.parameters, [](const Parameter& each) { return each.pointer == suite_place; })) {
    throw base::InputError({"/excitation/suite", "", "gives one test several records",
                            "give the record as \"file\", and infer each by itself"});
  }
  check_priors(experiment.unknowns);
}

Inference infer_unknowns(const Experiment& experiment, const InferRequest& request, const Execution& execution) {
  check_infer(experiment);
  if (request.tests.conditions.empty()) refuse("tests", "0 conditions", "must have at least one");
  if (request.next_tests < 1 || request.next_tests > 1000) {
    refuse("next_tests", std::to_string(request.next_tests), "must be a whole number from 1 to 1000");
  }
  if (request.seconds && !(*request.seconds > 0.0 && request.elapsed_seconds)) {
    refuse("seconds", base::shortest(*request.seconds), "must be positive, and needs a clock");
  }
  const OptionsOfExecution asked(execution);
  InferSimulation simulation(experiment, request.tests, seen_from(request.folder), asked.options());
  const InferenceQuestion question = inference_question(experiment, request.tests, request.next_tests, simulation);
  simulation.expect_sets(made_up_sets(question));
  InferenceSettings settings{.threads = asked.options().threads, .stop = asked.stop()};
  settings.on_made_up = [&simulation] { simulation.tell_set(); };
  settings.seconds = request.seconds;
  settings.elapsed_seconds = request.elapsed_seconds;
  settings.earlier = request.earlier;
  Inference found = infer_unknowns(question, settings);
  if (found.end == InferEnd::stopped && !request.keeps_when_stopped) throw base::Stopped();
  return found;
}

std::string infer_unknowns_text(const Experiment& experiment, const InferRequest& request, const Inference& found) {
  return infer_document().text(infer_report(experiment, request.tests, request.next_tests, found));
}

}  // namespace rocking
