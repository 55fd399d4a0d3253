#include "rocking/studies/threshold/study.hpp"

#include "rocking/fields/container_types.hpp"
#include "rocking/output/response_event_text.hpp"

namespace rocking {

const StructType& fields_of(const ThresholdQuestion*) {
  using Type = ThresholdQuestion;
  constexpr Rule in_files{.least = -1e18, .most = 1e18};
  static const StructType fields{
      "ThresholdQuestion",
      asked(field<&Type::of>("of", "JSON pointer to the number, such as /excitation/amplitude"),
            {.names = "--of", .letter = "PLACE", .is_required = true}),
      asked(field<&Type::from>("from", "Smallest value of the number; default: that of its sweep", in_files),
            {.names = "--from", .letter = "X"}),
      asked(field<&Type::to>("to", "Largest value of it; default: that of its sweep", in_files),
            {.names = "--to", .letter = "X"}),
      asked(field<&Type::event>("event",
                                "What is to happen within the horizon: overturning, tilt > X psi, deg or rad (the "
                                "largest; 1 psi is balance), slip > X m (the largest), displacement > X m (the slip at "
                                "the end); an overturned block has every event",
                                event_text_type()),
            {.names = "--event", .letter = "EVENT"}),
      asked(
          field<&Type::probability>(
              "probability",
              "Where something is random: the ends of the bands are the values at which the event has this probability",
              rule::confidence),
          {.names = "--probability", .letter = "P"}),
      asked(field<&Type::steps>("steps",
                                "Equal steps of the scan; a band or a gap that is narrower than one may be missed; "
                                "default: 200, or 20 with a probability",
                                Rule{.least = 1.0, .most = 1e6}),
            {.names = "--steps", .letter = "N"}),
      asked(field<&Type::accuracy>("accuracy",
                                   "Of an end of a band over its value; 0: to neighbouring doubles; default: 1e-9, or "
                                   "0.02 with a probability, where it is that of the whole 95 % interval",
                                   Rule{.least = 0.0, .most = 0.1}),
            {.names = "--accuracy", .letter = "E"}),
      asked(field<&Type::realisations>("realisations", "With a probability: most of them at one value",
                                       Rule{.least = 1.0, .most = 1e9}),
            {.names = "--realisations", .letter = "N"}),
  };
  return fields;
}

namespace {

void check(const Subject& subject, ThresholdQuestion& question) {
  question.folder = subject.folder;
  check_question(subject.experiment, question);
}

std::vector<analysis::Figure> figures_of(const ThresholdReport& report) {
  auto figure = analysis::threshold_figure(report);
  if (!figure) return {};
  return {*std::move(figure)};
}

Answer find(const Subject& subject, const ThresholdQuestion& question, const Circumstances& circumstances) {
  const ThresholdReport report{.input = input_of(subject.experiment),
                               .study = thresholds(subject.experiment, question, circumstances.execution)};
  Answer answer{.document = threshold_document().text(report),
                .table = threshold_table(report.study, circumstances.extent)};
  if (circumstances.draws) answer.figures = figures_of(report);
  return answer;
}

constexpr StudyFunctions<ThresholdQuestion> functions{
    .check = check, .find = find, .figures = figures_in<threshold_document, figures_of>};

}  // namespace

const Study& threshold_study() {
  static const Study study = study_of<ThresholdQuestion, functions>({
      .name = "threshold",
      .sentence = "Find where in a range of one number the block overturns, and where it stands again",
      .example = "pulse.json --of /excitation/amplitude --from 1 --to 10",
      .text = "scans the number in equal steps, bisects each change between standing and overturning, and prints the "
              "bands with the number of impacts on both sides of their ends. For each combination of the other swept "
              "values there are bands of their own: over a frequency they are the overturning spectrum, which "
              "`--figure` draws. Where something is random, `--probability 0.5` finds the values at which the event "
              "has this probability, each with a 95 % interval: realisations are added until the share of the event is "
              "told from the probability at both of its ends.",
      .python_notes = "Raises InputError if the place is not that of a number, if there is no range, or if something "
                      "is random without a probability, or the other way round.",
      .python_example = R"(>>> import rocking
>>> found = rocking.threshold({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "pulse", "shape": "sine", "amplitude": 1.0, "frequency_ratio": 5.0}, "restitution": 0.9},
...     of="/excitation/amplitude", from_=1, to=10, steps=20)
>>> round(found.conditions[0].threshold, 4)
4.2874)",
      .has_long_table = true,
      .draws = true,
      .progress = "motions",
      .file = "threshold.json",
      .document = threshold_document(),
      .without_figures = {"/conditions", "",
                          "have no other number with several values, over which a figure shows the bands",
                          "sweep another number, such as the frequency"},
  });
  return study;
}

}  // namespace rocking
