#include <algorithm>
#include <cmath>
#include <numeric>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
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
void check_earlier(const Experiment& experiment, const InferQuestion& question, QuestionCheck& check) {
  const std::uint64_t realisations = experiment.conditions.front().realisations;
  const std::size_t conditions = question.tests.conditions.size() + question.tests.candidates.size();
  for (std::size_t i = 0; i < question.earlier.size(); ++i) {
    const infer::DesignPoint& point = question.earlier[i];
    const std::string place = "earlier/" + std::to_string(i);
    check.expect_size(point.at.size(), experiment.unknowns.size(), place + "/at", "unknown");
    check.expect_size(point.counts.size(), conditions, place + "/counts", "condition");
    for (std::size_t c = 0; c < point.counts.size(); ++c) {
      const std::string of_condition = place + "/counts/" + std::to_string(c);
      check.expect_size(point.counts[c].size(), question.tests.groups.size(), of_condition, "group");
      const auto sum = std::accumulate(point.counts[c].begin(), point.counts[c].end(), std::uint64_t{0});
      check.expect(sum == realisations, of_condition, std::to_string(sum) + " realisations",
                   "must be those of the experiment, " + std::to_string(realisations));
    }
  }
}

}  // namespace

InferQuestion with_tests(const Experiment& experiment, InferQuestion question, const FileSource& files) {
  const auto text_of = [&files](const std::string& name) { return files(name, most_tests_bytes + 1); };
  check_infer(experiment);
  question.tests = read_tests(text_of(question.tests_file), question.tests_file, experiment, question.folder);
  if (const auto& file = question.candidates_file) {
    read_candidates(text_of(*file), *file, experiment, question.folder, question.tests);
  }
  return question;
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

void check_question(const Experiment& experiment, const InferQuestion& question) {
  check_infer(experiment);
  QuestionCheck check(question);
  check_tests(experiment, question.tests, check);
  check_earlier(experiment, question, check);
  check.finish();
}

Inference infer_unknowns(const Experiment& experiment, const InferQuestion& question, const Execution& execution,
                         const KeepDesign& keep) {
  check_question(experiment, question);
  if (question.seconds && !execution.elapsed_seconds) refuse("seconds", "", "needs a clock: `elapsed_seconds`");
  const OptionsOfExecution asked(execution);
  InferSimulation simulation(experiment, question.tests, seen_from(question.folder), asked.options());
  const InferenceSetting setting = inference_setting(experiment, question.tests, question.next_tests, simulation);
  simulation.expect_sets(made_up_sets(setting));
  Inference found = infer_unknowns(
      setting,
      {.seconds = question.seconds,
       .elapsed_seconds = execution.elapsed_seconds,
       .earlier = question.earlier,
       .keep = keep},
      {.threads = asked.options().threads, .stop = asked.stop(), .on_part = [&simulation] { simulation.tell_set(); }});
  if (found.end == InferEnd::stopped && !keep) throw base::Stopped();
  return found;
}

Inference infer_unknowns(const Experiment& experiment, const InferQuestion& question, const Execution& execution) {
  if (question.tests_file.empty()) return infer_unknowns(experiment, question, execution, {});
  return infer_unknowns(experiment, with_tests(experiment, question, files_seen_from("")), execution, {});
}

}  // namespace rocking
