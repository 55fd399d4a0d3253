#include "rocking/studies/comparison/study.hpp"

#include "rocking/studies/comparison/comparison.hpp"
#include "rocking/studies/comparison/result.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

struct NoQuestion {};

const StructType& fields_of(const NoQuestion*) {
  static const StructType fields{"NoQuestion"};
  return fields;
}

void check(const Subject& subject, NoQuestion&) {
  const NamedRun& first = subject.runs[0];
  const NamedRun& second = subject.runs[1];
  const Experiment& one = first.stored.experiment;
  const Experiment& other = second.stored.experiment;
  if (one.seed != other.seed) {
    throw UnfitQuestion(
        first.folder + " and " + second.folder +
            " have different seeds, so no common random numbers; run one of them again with the seed of the "
            "other",
        "/seed");
  }
  if (one.conditions.size() != other.conditions.size()) {
    throw UnfitQuestion(first.folder + " has " + counted(one.conditions.size(), "condition") + ", " + second.folder +
                            " has " + counted(other.conditions.size(), "condition") +
                            "; compare runs with the same number of conditions",
                        "/sweep");
  }
  if (const auto place = condition_with_other_record(one, other)) {
    throw UnfitQuestion(
        "condition " + std::to_string(*place) + " of " + first.folder + " and of " + second.folder +
            " has different records of a suite, so no common random numbers; compare runs with the same "
            "records in the same order",
        "/excitation/suite");
  }
}

Answer find(const Subject& subject, const NoQuestion&, const Circumstances& circumstances) {
  const StoredRun& first = subject.runs[0].stored;
  const Comparison found = compare(first, subject.runs[1].stored);
  return {.document = compare_text(found), .table = comparison_table(found, first.experiment, circumstances.extent)};
}

constexpr StudyFunctions<NoQuestion> functions{.check = check, .find = find};

}  // namespace

const Study& comparison_study() {
  static const Study study = study_of<NoQuestion, functions>({
      .name = "compare",
      .sentence = "Compare two runs, pairwise with common random numbers",
      .example = "out tighter",
      .text = "compares each realisation of out with the realisation of tighter that has the same random numbers. Both "
              "runs have the same seed, number of conditions and records; they may differ in anything else (amplitude, "
              "tolerance, formulation, sigma).",
      .python_notes = "The runs have the same seed, number of conditions and records of a suite; they may differ in "
                      "anything else. Realisations that only one run has are left out. Intervals have the confidence "
                      "of the first run. Raises InputError if the seeds, the numbers of conditions or the records "
                      "differ, OSError or StoreError as open_run().",
      .python_example = R"(>>> import rocking
>>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
>>> found = rocking.compare(rocking.run(slab), rocking.run({**slab, "restitution": 0.5}))
>>> found.settings
['/restitution is 0.9, not 0.5']
>>> found.conditions[0].realisations
10)",
      .subject = SubjectKind::two_runs,
      .has_long_table = true,
      .document = comparison_document(),
  });
  return study;
}

}  // namespace rocking
