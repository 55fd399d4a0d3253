#include "rocking/studies/rare/study.hpp"

#include <algorithm>

#include "rocking/api/question_check.hpp"

namespace rocking {
namespace {

const StructType& repetition_fields() {
  using rare::Repetition;
  static const StructType fields{
      "Repetition",
      field<&Repetition::estimate>("estimate", "of the probability", rule::not_negative),
      field<&Repetition::ancestors>("ancestors", "first trajectories from which those with the event descend"),
      field<&Repetition::work>("work", "in realisations to the horizon", rule::not_negative),
  };
  return fields;
}

const StructType& earlier_fields() {
  static const StructType fields{
      "RareEstimate",
      field<&RareEstimate::repetitions>("repetitions", "that are not made again",
                                        list_of<rare::Repetition, repetition_fields>()),
  };
  return fields;
}

}  // namespace

const StructType& fields_of(const RareQuestion*) {
  using Type = RareQuestion;
  static const StructType fields{
      "RareQuestion",
      asked(field<&Type::relative_error>("relative_error", "Standard error over the probability that is aimed at",
                                         Rule{.least = 1e-3, .most = 1.0}),
            {.names = "--relative-error", .letter = "E"}),
      asked(
          field<&Type::event>("event",
                              "What the probability is of: overturning, tilt > X psi, deg or rad (the largest; 1 psi "
                              "is the unstable equilibrium); where all numbers are drawn once also slip > X m (the "
                              "largest), displacement > X m (the slip at the end); an overturned block has every event",
                              event_text_type()),
          {.names = "--event", .letter = "EVENT"}),
      asked(field<&Type::seconds>("seconds",
                                  "Stop after this time for all conditions together, e.g. 10min; what is finished then "
                                  "counts, so that the result depends on the time",
                                  rule::positive),
            {.names = "--max-time,--at-most-work", .letter = "T", .kind = FlagKind::duration}),
      asked(
          field<&Type::particles>("particles", "Trajectories of a repetition", Rule{.least = 20.0, .most = 100'000.0}),
          {.names = "--particles", .letter = "N"}),
      field<&Type::earlier>("earlier", "estimates of an earlier study, by condition",
                            list_of<RareEstimate, earlier_fields>()),
  };
  return fields;
}

namespace {

void check(const Subject& subject, RareQuestion& question) {
  question.event = in_units_of_balance(question.event, subject.experiment.conditions);
  check_question(subject.experiment, question);
}

void resume(const Subject& subject, RareQuestion& question, const Json& earlier) {
  question.earlier = estimates_for(rare_report(subject.experiment, question, {}), rare_document().read(earlier));
}

Answer find(const Subject& subject, const RareQuestion& question, const Circumstances& circumstances) {
  const auto report_on = [&](const std::vector<RareEstimate>& found) {
    return rare_report(subject.experiment, question, found);
  };
  KeepRare keep;
  if (circumstances.keep) {
    keep = [&](const std::function<std::vector<RareEstimate>()>& so_far) {
      circumstances.keep([&] { return rare_document().text(report_on(so_far())); });
    };
  }
  const RareReport report = report_on(rare_probabilities(subject.experiment, question, circumstances.execution, keep));
  const bool is_stopped =
      std::ranges::any_of(report.conditions, [](const auto& one) { return one.estimate.end == RareEnd::stopped; });
  std::optional<BalanceAngles> balance;
  for (const Condition& condition : subject.experiment.conditions) {
    balance = joined(balance, balance_of(condition.scene));
  }
  return {.document = rare_document().text(report),
          .table = rare_table(report, in_degrees(report.question.event, balance)),
          .end = is_stopped ? AnswerEnd::stopped : AnswerEnd::complete};
}

constexpr StudyFunctions<RareQuestion> functions{
    .check = check, .find = find, .resume = resume, .figures = figures_in<rare_document, analysis::rare_figures>};

}  // namespace

const Study& rare_study() {
  static const Study study = study_of<RareQuestion, functions>({
      .name = "rare",
      .sentence = "Estimate the probability of rare overturning",
      .example = "experiments/headline/headline.json -o out --max-time 10min",
      .text = "estimates probabilities far below 1 over the number of simulated realisations: by a particle run that "
              "prefers motions from which overturning is likely, or by importance sampling where all numbers are drawn "
              "once. Writes the probability of each condition with its interval to out/rare.json and prints it. "
              "Something must be random.",
      .python_notes = "Without ``max_time`` the same is estimated again. Raises InputError if nothing in a condition "
                      "is random or a number is out of range.",
      .python_example = R"(>>> import rocking
>>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "seed": "0x1"}
>>> estimate, = rocking.rare(slab, event="tilt > 0.05 psi", particles=20, relative_error=1.0).conditions
>>> estimate.interval[0] <= estimate.probability <= estimate.interval[1]
True)",
      .takes_seed = true,
      .progress = "realisations",
      .file = "rare.json",
      .needs_folder = true,
      .kept = "repetitions",
      .document = rare_document(),
      .without_figures = {"/conditions/0/paths", "", "are missing: a figure shows how the event happens",
                          "give `rocking rare` more time"},
      .verification = {.verify = verify_rare,
                       .progress = "realisations",
                       .unit = "repetition",
                       .units_key = "repetitions_run_again",
                       .and_more = " and the pilot runs"},
      .is_shown_with_run = true,
  });
  return study;
}

}  // namespace rocking
