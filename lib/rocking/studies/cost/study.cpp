#include "rocking/studies/cost/study.hpp"

#include <algorithm>

#include "rocking/api/system_facts.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/studies/cost/budget.hpp"
#include "rocking/studies/cost/figure.hpp"
#include "rocking/studies/cost/result.hpp"
#include "rocking/studies/cost/table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

const StructType& fields_of(const CostRequest*) {
  static const StructType fields{
      "CostRequest",
      asked(field<&CostRequest::seconds>(
                "seconds", "Measure as many realisations as possible in about this time, at least one, e.g. 5min",
                rule::positive),
            {.names = "--max-time,--time", .letter = "T", .kind = FlagKind::duration}),
      asked(field<&CostRequest::sample>(
                "sample", "Measure N realisations; the same experiment gives the same numbers again, except times",
                Rule{.least = 1.0, .most = static_cast<double>(largest_cost_sample)}),
            {.names = "--sample", .letter = "N", .excludes = "--max-time"}),
      asked(field<&CostRequest::tolerances>(
                "tolerances",
                "These tolerances instead of 1e-4, 1e-5, ... 1e-14; the experiment's own is added, and the tightest "
                "is the reference",
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
    const double fixed = static_cast<double>(horizon.transient_periods) + horizon.sampled_periods;
    most = std::max(most, static_cast<double>(horizon.until_classified->at_most_periods) / fixed);
  }
  if (most <= 1.0) return "";
  return "until_classified: errors, response modes and times are those of the fixed horizon. A realisation that goes "
         "on "
         "to its limit has " +
         significant(most, 3) + " times as many periods; `rocking run --dry-run` estimates how many go on\n";
}

CostRequest with_clocks(CostRequest request, const Circumstances& circumstances) {
  request.elapsed_seconds = circumstances.elapsed_seconds;
  request.processor_seconds = circumstances.processor_seconds;
  return request;
}

void check(const Subject& subject, CostRequest& request) {
  const auto no_clock = [] { return 0.0; };
  check_request(subject.experiment, with_clocks(request, {.elapsed_seconds = no_clock, .processor_seconds = no_clock}));
}

Answer find(const Subject& subject, const CostRequest& request, const Circumstances& circumstances) {
  const double start = circumstances.elapsed_seconds();
  MeasuredCost measured{.experiment = &subject.experiment,
                        .cost = cost(subject.experiment, with_clocks(request, circumstances), circumstances.execution),
                        .system = facts_of(circumstances.provenance)};
  measured.system.duration_s = circumstances.elapsed_seconds() - start;
  return {.document = cost_document().text(cost_report(measured)),
          .table = cost_table(measured) + fixed_horizon_note(subject.experiment)};
}

std::vector<analysis::Figure> figures(const Json& document, std::span<const Json>) {
  return analysis::cost_figures(cost_document().read(document));
}

constexpr StudyFunctions<CostRequest> functions{.check = check, .find = find, .figures = figures};

}  // namespace

const Study& cost_study() {
  static const Study study = study_of<CostRequest, functions>({
      .name = "cost",
      .sentence = "Measure the cost of accuracy in time, on a sample of an experiment",
      .example = "experiments/headline/headline.json --max-time 5min -o out",
      .text =
          "runs a sample of the realisations at a series of tolerances with common random numbers. Prints, for each "
          "tolerance, the error, the number of response modes that change, and the time per period; for larger "
          "numbers of realisations, the width of the intervals and the time; and a recommended tolerance. `-o` saves "
          "the numbers in out/cost.json. Times are processor times of this machine.",
      .python_notes = "With ``sample``, ``seconds`` limits the measurement of speed. The last of the tolerances is the "
                      "reference; together with those of the experiment they are at least three. Times are processor "
                      "times of this machine. Raises InputError for a number out of range.",
      .python_example = R"(>>> import rocking
>>> found = rocking.cost({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "accuracy": {"tolerance": 1e-10}},
...     sample=1, seconds=0.1, tolerances=[1e-6, 1e-14])
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
