#include "rocking/studies/cost/study.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/cost/cost.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// Time for the measurement of speed, relative to the time for the sample. Together they take the requested time; if
/// the sample takes less than its share, the measurement of speed may take a few seconds.
constexpr double timing_share = 1.0 / 3.0;
constexpr double few_seconds = 5.0;

/// Wall-clock time for the sample [s], where the number of its realisations is not given.
double time_for_sample(const CostQuestion& question) { return question.seconds / (1.0 + timing_share); }

/// Realisations that a measurement will reach in its time, judged by those that are done.
std::uint64_t expected_sample(const CostQuestion& question, std::uint64_t done, double elapsed_seconds) {
  const double all = static_cast<double>(done) * time_for_sample(question) / std::max(elapsed_seconds, 1e-9);
  return std::max(done, static_cast<std::uint64_t>(std::min(all, static_cast<double>(largest_cost_sample))));
}

/// `asked` and those of all conditions, falling; the usual ones (tolerance_ladder) if none are asked for. A measurement
/// needs at least three: the last is the reference, the one before it the floor.
std::vector<double> cost_tolerances(const Experiment& experiment, std::span<const double> asked) {
  if (asked.empty()) return tolerance_ladder(experiment);
  std::set<double, std::greater<>> all(asked.begin(), asked.end());
  const std::vector<double> own = own_tolerances(experiment);
  all.insert(own.begin(), own.end());
  return {all.begin(), all.end()};
}

}  // namespace

void check_question(const Experiment& experiment, const CostQuestion& question) {
  check_has_conditions(experiment);
  check_strobe(experiment);
  check_fields(question);
  if (cost_tolerances(experiment, question.tolerances).size() < 3) {
    refuse("tolerances", "",
           "are fewer than three with the experiment's own; the tightest is the reference and the second tightest the "
           "floor, so give at least three, for example 1e-8, 1e-11, 1e-14");
  }
}

Cost cost(const Experiment& experiment, const CostQuestion& question, const Execution& execution) {
  check_question(experiment, question);
  if (!execution.elapsed_seconds || !execution.processor_seconds) {
    throw std::invalid_argument("a measurement of cost needs both clocks: elapsed_seconds and processor_seconds");
  }
  const OptionsOfExecution asked(execution);
  const RunOptions& options = asked.options();
  const double start = execution.elapsed_seconds();
  const auto elapsed = [&] { return execution.elapsed_seconds() - start; };
  CostPlan plan{.tolerances = cost_tolerances(experiment, question.tolerances),
                .sample = question.sample.value_or(largest_cost_sample)};
  if (!question.sample) plan.is_enough = [&] { return elapsed() >= time_for_sample(question); };
  RunOptions sampling = options;
  if (options.on_progress && !question.sample) {
    sampling.on_progress = [&](std::uint64_t done, std::uint64_t all) {
      options.on_progress(done, std::min(all, expected_sample(question, done, elapsed())));
    };
  }
  const auto sample = measure_cost(experiment, plan, sampling);
  const double spent = elapsed();
  const double spare = std::min(few_seconds, question.sample ? question.seconds : question.seconds - spent);
  const double end = spent + std::max(timing_share * spent, spare);
  auto timing = time_cost(
      experiment, plan.tolerances,
      {.processor_seconds = execution.processor_seconds, .seconds_left = [&] { return end - elapsed(); }}, options);
  asked.stop().check();
  return cost_of(experiment, plan.tolerances, sample, std::move(timing));
}

const StructType& fields_of(const CostQuestion*) {
  static const StructType fields{
      "CostQuestion",
      asked(field<&CostQuestion::seconds>(
                "seconds", "Measure as many realisations as possible in about this time, e.g. 5min, and at least one",
                rule::positive),
            {.names = "--max-time,--time", .letter = "T", .kind = FlagKind::duration}),
      asked(field<&CostQuestion::sample>(
                "sample", "Measure N realisations; the same experiment gives the same numbers again, except times",
                Rule{.least = 1.0, .most = static_cast<double>(largest_cost_sample)}),
            {.names = "--sample", .letter = "N", .excludes = "--max-time"}),
      asked(field<&CostQuestion::tolerances>("tolerances",
                                             "These tolerances instead of 1e-4, 1e-5, ... 1e-14; the experiment's own "
                                             "is added, and the tightest is the reference",
                                             Rule{.least = 1e-16, .most = 1e-2}),
            {.names = "--tolerances", .letter = "T,T,T", .kind = FlagKind::commas}),
  };
  return fields;
}

namespace {

/// A line on until_classified; empty if no condition has it.
std::string fixed_horizon_note(const Experiment& experiment) {
  double most = 0.0;
  for (const Condition& condition : experiment.conditions) {
    const Horizon& horizon = condition.horizon;
    if (!horizon.until_classified) continue;
    const double fixed = static_cast<double>(horizon.periods());
    most = std::max(most, static_cast<double>(horizon.until_classified->at_most_periods) / fixed);
  }
  if (most <= 1.0) return "";
  return "until_classified: errors, response modes and times are those of the fixed horizon. A realisation that goes "
         "on to its limit has " +
         significant(most, 3) + " times as many periods; `rocking run --dry-run` estimates how many go on\n";
}

void check(const Subject& subject, CostQuestion& question) { check_question(subject.experiment, question); }

Answer find(const Subject& subject, const CostQuestion& question, const Circumstances& circumstances) {
  const Execution& execution = circumstances.execution;
  const double start = execution.elapsed_seconds();
  MeasuredCost measured{.experiment = &subject.experiment,
                        .cost = cost(subject.experiment, question, execution),
                        .system = facts_of(circumstances.provenance)};
  measured.system.duration_s = execution.elapsed_seconds() - start;
  return {.document = cost_document().text(cost_report(measured)),
          .table = cost_table(measured) + fixed_horizon_note(subject.experiment)};
}

constexpr StudyFunctions<CostQuestion> functions{
    .check = check, .find = find, .figures = figures_in<cost_document, analysis::cost_figures>};

}  // namespace

const Study& cost_study() {
  static const Study study = study_of<CostQuestion, functions>({
      .name = "cost",
      .sentence = "Measure the cost of accuracy in time, on a sample of an experiment",
      .example = "experiments/headline/headline.json --max-time 5min -o out",
      .text = "runs a sample of the realisations at a series of tolerances with common random numbers. Prints, for "
              "each tolerance, the error, the number of response modes that change, and the time per period; for "
              "larger numbers of realisations, the width of the intervals and the time; and a recommended tolerance. "
              "`-o` saves the numbers in out/cost.json. Times are processor times of this machine.",
      .python_notes =
          "The last of the tolerances is the reference; together with those of the experiment they are at least three. "
          "Times are processor times of this machine. Raises InputError for a number out of range.",
      .python_example = R"(>>> import rocking
>>> found = rocking.cost({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "accuracy": {"tolerance": 1e-10}},
...     max_time=0.2, tolerances=[1e-6, 1e-14])
>>> found.result.tolerances.column("tolerance")
array([1.e-06, 1.e-10, 1.e-14])
>>> coarse, fine, reference = found.result.tolerances.column("departure.error.median")
>>> bool(coarse > fine)
True)",
      .takes_seed = true,
      .realisations = "Intended realisations per condition, instead of the file's",
      .progress = "realisations",
      .file = "cost.json",
      .document = cost_document(),
  });
  return study;
}

}  // namespace rocking
