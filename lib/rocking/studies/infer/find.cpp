#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/read_tests.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/infer/infer.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

bool leads_somewhere(const std::string& pointer, const Json& experiment) {
  try {
    return pointer.starts_with('/') && experiment.contains(Json::json_pointer(pointer));
  } catch (const Json::exception&) {
    return false;  // not a pointer at all
  }
}

/// Whether the parameters of a condition can be set. What is wrong with a value is found where it is set.
void check_parameters(const Experiment& experiment, const Json& document, const TestedCondition& tested,
                      const std::string& place, QuestionCheck& check) {
  for (std::size_t i = 0; i < tested.parameters.size(); ++i) {
    const std::string& pointer = tested.parameters[i].pointer;
    const std::string of_parameter = place + "/parameters/" + std::to_string(i);
    const bool is_unknown =
        std::ranges::find(experiment.unknowns, pointer, &Unknown::pointer) != experiment.unknowns.end();
    check.expect(!is_unknown, of_parameter, pointer, "is an unknown");
    check.expect(leads_somewhere(pointer, document), of_parameter, pointer, "is not in the experiment");
    const auto* part = std::get_if<WrittenPart>(&tested.parameters[i].value);
    if (part != nullptr) check.expect(Json::accept(part->text), of_parameter, part->text, "is not JSON text");
  }
}

void check_tests(const Experiment& experiment, const CountedTests& tests, QuestionCheck& check) {
  const Json document = Json::parse(experiment.canonical_text);
  check.expect(!tests.groups.empty(), "tests/groups", "0 groups", "must have at least one, of all response modes");
  check.expect(!tests.conditions.empty(), "tests", "0 conditions", "must have at least one");
  for (const auto* list : {&tests.conditions, &tests.candidates}) {
    const bool is_candidate = list == &tests.candidates;
    const std::string name = is_candidate ? "candidates" : "tests";
    check.expect(list->size() <= most_tested_conditions, name, std::to_string(list->size()) + " conditions",
                 "must be at most " + std::to_string(most_tested_conditions));
    for (std::size_t i = 0; i < list->size(); ++i) {
      const TestedCondition& one = (*list)[i];
      const std::string place = name + '/' + std::to_string(i);
      check_parameters(experiment, document, one, place, check);
      check.expect_size(one.counts.size(), is_candidate ? 0 : tests.groups.size(), place + "/counts", "group");
      const bool has_tests = std::ranges::any_of(one.counts, [](std::uint64_t count) { return count > 0; });
      check.expect(is_candidate || has_tests, place + "/counts", "", "has no tests");
    }
  }
}

/// Points of an earlier answer to the same question.
void check_earlier(const Experiment& experiment, const InferRequest& request, QuestionCheck& check) {
  const std::uint64_t realisations = experiment.conditions.front().realisations;
  const std::size_t conditions = request.tests.conditions.size() + request.tests.candidates.size();
  for (std::size_t i = 0; i < request.earlier.size(); ++i) {
    const infer::DesignPoint& point = request.earlier[i];
    const std::string place = "earlier/" + std::to_string(i);
    check.expect_size(point.at.size(), experiment.unknowns.size(), place + "/at", "unknown");
    check.expect_size(point.counts.size(), conditions, place + "/counts", "condition");
    for (std::size_t c = 0; c < point.counts.size(); ++c) {
      const std::string of_condition = place + "/counts/" + std::to_string(c);
      check.expect_size(point.counts[c].size(), request.tests.groups.size(), of_condition, "group");
      const auto sum = std::accumulate(point.counts[c].begin(), point.counts[c].end(), std::uint64_t{0});
      check.expect(sum == realisations, of_condition, std::to_string(sum) + " realisations",
                   "must be those of the experiment, " + std::to_string(realisations));
    }
  }
}

}  // namespace

CountedTests counted_tests(const Experiment& experiment, const FileSource& files, const std::string& tests,
                           const std::optional<std::string>& candidates, const std::filesystem::path& folder) {
  CountedTests read = read_tests(files(tests, most_tests_bytes + 1), tests, experiment, folder);
  if (candidates) read_candidates(files(*candidates, most_tests_bytes + 1), *candidates, experiment, folder, read);
  return read;
}

CountedTests counted_tests(const Experiment& experiment, const std::filesystem::path& tests,
                           const std::optional<std::filesystem::path>& candidates,
                           const std::filesystem::path& folder) {
  const std::optional<std::string> others = candidates ? std::optional(candidates->string()) : std::nullopt;
  return counted_tests(experiment, files_seen_from(""), tests.string(), others, folder);
}

void check_infer(const Experiment& experiment) {
  check_has_conditions(experiment);
  check_strobe(experiment);
  if (experiment.canonical_text.empty()) {
    throw base::InputError({"/unknown", "", "is a place in a text, and this experiment was made in C++ without one",
                            "read the experiment from a file, or parse its text"});
  }
  if (experiment.unknowns.empty()) {
    throw base::InputError(
        {"/unknown", "", "is missing: there is nothing to infer",
         "add for example \"unknown\": [{\"parameter\": \"/friction/static\", \"from\": 0.2, \"to\": 0.6}]"});
  }
  if (experiment.unknowns.size() > most_unknowns) {
    throw base::InputError({"/unknown", std::to_string(experiment.unknowns.size()) + " entries",
                            "must be a list of one to three entries", ""});
  }
  for (std::size_t i = 0; i < experiment.unknowns.size(); ++i) {
    const auto& [pointer, from, to, prior] = experiment.unknowns[i];
    if (std::isfinite(from) && std::isfinite(to) && from < to) continue;
    throw base::InputError({"/unknown/" + std::to_string(i) + "/to", base::shortest(to), "is not above \"from\"", ""});
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

void check_request(const Experiment& experiment, const InferRequest& request) {
  check_infer(experiment);
  QuestionCheck check(request);
  check.expect(!request.seconds || request.elapsed_seconds, "seconds", "", "needs a clock: `elapsed_seconds`");
  check_tests(experiment, request.tests, check);
  check_earlier(experiment, request, check);
  check.finish();
}

Inference infer_unknowns(const Experiment& experiment, const InferRequest& request, const Execution& execution) {
  check_request(experiment, request);
  const OptionsOfExecution asked(execution);
  InferSimulation simulation(experiment, request.tests, seen_from(request.folder), asked.options());
  const InferenceQuestion question = inference_question(experiment, request.tests, request.next_tests, simulation);
  simulation.expect_sets(made_up_sets(question));
  Inference found = infer_unknowns(
      question, request,
      {.threads = asked.options().threads, .stop = asked.stop(), .on_part = [&simulation] { simulation.tell_set(); }});
  if (found.end == InferEnd::stopped && !request.keeps_when_stopped) throw base::Stopped();
  return found;
}

}  // namespace rocking
