#include "rocking/studies/infer/infer.hpp"

#include "rocking/base/error.hpp"
#include "rocking/input/condition_family.hpp"

namespace rocking {

InferSimulation::InferSimulation(const Experiment& experiment, const CountedTests& tests,
                                 const Surroundings& surroundings, const RunOptions& options)
    : experiment_(&experiment),
      tests_(&tests),
      condition_at_(ConditionMaker(experiment, surroundings)),
      options_(options) {
  const auto on_progress = options.on_progress;
  if (!on_progress) return;
  options_.on_progress = [this, on_progress](std::uint64_t done, std::uint64_t all) {
    on_progress(earlier_ + done, earlier_ + all + later_);
  };
}

void InferSimulation::tell_set() {
  ++made_up_;
  if (options_.on_progress) options_.on_progress(made_up_, 0);
}

CountsAtPoints InferSimulation::counts_at(const std::vector<std::vector<double>>& points) {
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

Condition InferSimulation::condition(const TestedCondition& tested, const std::vector<double>& at) const {
  std::vector<Parameter> values = tested.parameters;
  for (std::size_t k = 0; k < at.size(); ++k) {
    values.push_back({experiment_->unknowns[k].pointer, at[k]});
  }
  Condition condition = condition_at_(values);
  condition.rerun_every = 0;
  if (condition.horizon.until_classified) condition.horizon.until_classified->long_run_every = 0;
  return condition;
}

/// Where nothing is random, one realisation stands for all.
std::vector<std::uint64_t> InferSimulation::counts_of(const ConditionResult& result, std::uint64_t realisations) const {
  if (const std::uint64_t without_answer = result.without_answer(); without_answer > 0) {
    throw base::InputError({"/unknown", "",
                            "has values at which " + std::to_string(without_answer) + " of " +
                                std::to_string(result.realisations) +
                                " realisations of a condition end before their horizon without an answer, by a budget "
                                "of steps or by Painleve's paradox: their response modes cannot be counted",
                            "leave these values out (first in the order of the design: a corner of the box), or "
                            "lengthen /fluctuation/friction/refresh_slip_m"});
  }
  std::vector<std::uint64_t> counts(tests_->groups.size());
  const std::uint64_t each = result.is_random() ? 1 : realisations;
  for (const ModeEstimate& mode : result.modes) {
    counts[group_of(tests_->groups, mode.mode)] += each * mode.probability.counts.successes;
  }
  return counts;
}

InferenceSetting inference_setting(const Experiment& experiment, const CountedTests& tests, std::uint64_t next_tests,
                                   InferSimulation& simulation) {
  return {.unknowns = experiment.unknowns,
          .tests = tests,
          .confidence = experiment.conditions.front().confidence,
          .seed = experiment.seed,
          .next_tests = next_tests,
          .simulate = [&simulation](const auto& points) { return simulation.counts_at(points); }};
}

}  // namespace rocking
