#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "rocking/api/infer.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/read_tests.hpp"
#include "rocking/output/infer_report.hpp"
#include "rocking/studies/infer/infer.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// Simulates the conditions of the tests and of the candidates at values of the unknowns.
class Simulation {
 public:
  Simulation(const Experiment& experiment, const InferRequest& request, const RunOptions& options)
      : experiment_(&experiment),
        tests_(&request.tests),
        condition_at_(condition_maker(experiment, request.folder)),
        options_(options) {
    const auto on_progress = options.on_progress;
    if (!on_progress) return;
    options_.on_progress = [this, on_progress](std::uint64_t done, std::uint64_t all) {
      on_progress(earlier_ + done, earlier_ + all);
    };
  }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  [[nodiscard]] CountsAtPoints counts_at(const std::vector<std::vector<double>>& points) {
    Experiment batch{.title = "", .seed = experiment_->seed, .conditions = {}, .canonical_text = "null"};
    for (const std::vector<double>& at : points) {
      for (const auto* conditions : {&tests_->conditions, &tests_->candidates}) {
        for (const TestedCondition& tested : *conditions) batch.conditions.push_back(condition(tested, at));
      }
    }
    const std::optional<ExperimentResult> result = run(batch, options_);
    if (!result) throw base::Stopped();
    CountsAtPoints counts;
    const std::size_t conditions = batch.conditions.size() / points.size();
    for (std::size_t i = 0; i < batch.conditions.size(); ++i) {
      if (i % conditions == 0) counts.emplace_back();
      counts.back().push_back(counts_of(result->conditions[i], batch.conditions[i].realisations));
      earlier_ += effective_realisations(batch.conditions[i]);
    }
    return counts;
  }

 private:
  [[nodiscard]] Condition condition(const TestedCondition& tested, const std::vector<double>& at) const {
    std::vector<Parameter> values = tested.parameters;
    for (std::size_t k = 0; k < at.size(); ++k) {
      values.push_back({experiment_->unknowns[k].pointer, base::shortest(at[k])});
    }
    Condition condition = condition_at_(values);
    condition.rerun_every = 0;
    if (condition.horizon.until_classified) condition.horizon.until_classified->long_run_every = 0;
    return condition;
  }

  /// Where nothing is random, one realisation stands for all.
  [[nodiscard]] std::vector<std::uint64_t> counts_of(const ConditionResult& result, std::uint64_t realisations) const {
    std::vector<std::uint64_t> counts(tests_->groups.size());
    const std::uint64_t each = result.is_random() ? 1 : realisations;
    for (const ModeEstimate& mode : result.modes) {
      counts[group_of(tests_->groups, mode.mode)] += each * mode.probability.counts.successes;
    }
    return counts;
  }

  const Experiment* experiment_;
  const CountedTests* tests_;
  std::function<Condition(const std::vector<Parameter>&)> condition_at_;
  RunOptions options_;
  std::uint64_t earlier_ = 0;  ///< realisations of earlier calls
};

}  // namespace

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
  if (std::ranges::any_of(first.parameters,
                          [](const Parameter& each) { return each.pointer == "/excitation/suite"; })) {
    throw base::InputError({"/excitation/suite", "", "gives one test several records",
                            "give the record as \"file\", and infer each by itself"});
  }
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
  Simulation simulation(experiment, request, asked.options());
  const InferenceQuestion question{
      .unknowns = experiment.unknowns,
      .tests = request.tests,
      .confidence = experiment.conditions.front().confidence,
      .seed = experiment.seed,
      .next_tests = request.next_tests,
      .simulate = [&simulation](const auto& points) { return simulation.counts_at(points); }};
  InferenceSettings settings{.threads = asked.options().threads, .stop = asked.stop()};
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
