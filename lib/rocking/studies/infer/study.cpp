#include "rocking/studies/infer/study.hpp"

#include "rocking/api/question_check.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/output/findings.hpp"

namespace rocking {
namespace {

/// Of a condition, by group.
const Rule tests_rule{.most = static_cast<double>(most_tests)};

const StructType& tested_condition_fields() {
  static const StructType fields{
      "TestedCondition",
      field<&TestedCondition::counts>("counts", "of tests by group", tests_rule),
  };
  return fields;
}

const StructType& design_point_fields() {
  using infer::DesignPoint;
  static const StructType fields{
      "DesignPoint",
      field<&DesignPoint::at>("at", "values of the unknowns"),
      field<&DesignPoint::counts>("counts", "of realisations, by condition and by group"),
  };
  return fields;
}

}  // namespace

const StructType& fields_of(const InferQuestion*) {
  using Type = InferQuestion;
  static const StructType fields{
      "InferQuestion",
      asked(field<&Type::tests_file>("tests_file", "Counted tests, CSV: a line for each condition"),
            {.names = "--tests", .letter = "FILE", .is_required = true}),
      asked(field<&Type::candidates_file>(
                "candidates_file",
                "Conditions that may be tested next, CSV without counts: how much each would narrow the region"),
            {.names = "--candidates", .letter = "FILE"}),
      field<&Type::tests, &CountedTests::conditions>("tests", "by tested condition",
                                                     list_of<TestedCondition, tested_condition_fields>()),
      asked(
          field<&Type::next_tests>("next_tests", "Tests of a candidate condition", Rule{.least = 1.0, .most = 1000.0}),
          {.names = "--next-tests", .letter = "N"}),
      asked(field<&Type::seconds>("seconds",
                                  "Add no points to the design after this time, e.g. 10min, and answer from those that "
                                  "are finished, so that the answer depends on the time",
                                  rule::positive),
            {.names = "--max-time", .letter = "T", .kind = FlagKind::duration}),
      field<&Type::earlier>("earlier", "points of an earlier answer",
                            list_of<infer::DesignPoint, design_point_fields>()),
  };
  return fields;
}

namespace {

InferReport report_on(const Subject& subject, const InferQuestion& question, const Inference& found) {
  return infer_report(subject.experiment, question.tests, question.next_tests, found);
}

void check(const Subject& subject, InferQuestion& question) {
  question.folder = subject.folder;
  question = with_tests(subject.experiment, std::move(question), subject.files);
}

void resume(const Subject& subject, InferQuestion& question, const Json& earlier) {
  question.earlier = design_for(report_on(subject, question, {}), infer_document().read(earlier));
}

/// Numbers of the tested conditions that have another unit than their column more likely than not.
std::vector<std::string> doubts_of(const Subject& subject, const CountedTests& tests) {
  const ConditionMaker condition_with(subject.experiment, seen_from(subject.folder));
  Experiment tested;
  for (const TestedCondition& condition : tests.conditions) {
    tested.conditions.push_back(condition_with(condition.parameters));
  }
  std::vector<std::string> doubts;
  if (tested.conditions.empty()) return doubts;
  for (const Finding& each : suspicious_numbers(tested)) doubts.push_back(in_words(each));
  return doubts;
}

Answer find(const Subject& subject, const InferQuestion& question, const Circumstances& circumstances) {
  KeepDesign keep;
  if (circumstances.keep) {
    keep = [&](const std::vector<infer::DesignPoint>& design) {
      circumstances.keep([&] {
        return infer_document().text(
            report_on(subject, question, {.design = design, .answer = {}, .end = InferEnd::stopped}));
      });
    };
  }
  const Inference found = infer_unknowns(subject.experiment, question, circumstances.execution, keep);
  const InferReport report = report_on(subject, question, found);
  return {.document = infer_document().text(report),
          .table = infer_table(report),
          .warnings = doubts_of(subject, question.tests),
          .end = found.end == InferEnd::stopped ? AnswerEnd::stopped : AnswerEnd::complete};
}

constexpr StudyFunctions<InferQuestion> functions{
    .check = check, .find = find, .resume = resume, .figures = figures_in<infer_document, analysis::infer_figures>};

}  // namespace

const Study& infer_study() {
  static const Study study = study_of<InferQuestion, functions>({
      .name = "infer",
      .sentence = "Infer unknown numbers from counted tests",
      .example = "campaign.json --tests tests.csv -o out",
      .text = "answers which values of the unknowns of the experiment (its key `unknown`) make the counted response "
              "modes of tests likely: estimates, intervals, a joint region, and whether the counts fit at all. "
              "tests.csv has a line for each tested condition: parameters by JSON pointer or last key, then a column "
              "of counts for each response mode, such as \"(1,1)\" or other. Writes out/infer.json.",
      .python_notes = "``source`` is an experiment with ``unknown``. Raises InputError with the line or row of each "
                      "fault, OSError if a file cannot be read.",
      .python_example = R"(>>> import rocking
>>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0,
...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
...     "horizon": {"transient_periods": 10, "sampled_periods": 10}, "realisations": 20, "seed": "0x1",
...     "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}]}
>>> unknown, = rocking.infer(slab, {"amplitude": [4.0], "overturned": [1], "other": [4]}).unknowns
>>> unknown.interval[0] <= unknown.estimate <= unknown.interval[1]
True)",
      .takes_seed = true,
      .realisations = "Realisations of each condition at each point, instead of the file's",
      .progress = "realisations and made-up data sets",
      .file = "infer.json",
      .needs_folder = true,
      .kept = "points",
      .document = infer_document(),
      .without_figures = {"/fit", "null", "there is no answer yet: a figure shows the answer",
                          "finish it with `rocking infer --resume`"},
      .verification =
          {.verify = verify_infer, .progress = "realisations", .unit = "point", .units_key = "points_run_again"},
      .is_shown_with_run = true,
  });
  return study;
}

}  // namespace rocking
