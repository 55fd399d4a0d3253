#include "rocking/studies/bifurcation/study.hpp"

#include "rocking/studies/orbits/study.hpp"

namespace rocking {
namespace {

struct BifurcationQuestion {
  std::uint64_t realisation = 0;
};

const StructType& fields_of(const BifurcationQuestion*) {
  static const StructType fields{
      "BifurcationQuestion",
      asked(field<&BifurcationQuestion::realisation>(
                "realisation", "Realisation whose random numbers are used, if something is random",
                Rule{.least = 0.0, .most = 999'999'999.0}),
            {.names = "--realisation", .letter = "K"}),
  };
  return fields;
}

void check(const Subject& subject, BifurcationQuestion&) { static_cast<void>(diagrams_of(subject.experiment)); }

std::vector<std::string> files(const Subject&) { return {"bifurcation.csv"}; }

Answer find(const Subject& subject, const BifurcationQuestion& question, const Circumstances& circumstances) {
  const Experiment& experiment = subject.experiment;
  const std::vector<Diagram> diagrams = bifurcation(experiment, question.realisation, circumstances.execution);
  return {.document = bifurcation_document().text(bifurcation_report(experiment, question.realisation, diagrams)),
          .table = bifurcation_table(experiment, diagrams, circumstances.extent),
          .files = {{"bifurcation.csv", bifurcation_csv(experiment, diagrams)}}};
}

/// Branches of orbits are drawn over the diagrams over the same parameter.
std::vector<analysis::Figure> figures(const Json& document, std::span<const Json> others) {
  const BifurcationReport report = bifurcation_document().read(document);
  std::vector<analysis::Figure> drawn = analysis::bifurcation_figures(report);
  for (const Json& other : others) {
    if (other.at("format") != orbits_document().format()) continue;
    const OrbitsReport orbits = orbits_document().read(other);
    if (!orbits.study.branches || orbits.study.branches->pointer != report.parameter) continue;
    for (analysis::Figure& figure : drawn) draw_branches_over(orbits.study, figure);
  }
  return drawn;
}

constexpr StudyFunctions<BifurcationQuestion> functions{
    .check = check, .find = find, .files = files, .figures = figures};

}  // namespace

const Study& bifurcation_study() {
  static const Study study = study_of<BifurcationQuestion, functions>({
      .name = "bifurcation",
      .sentence = "Follow the responses along a swept parameter; shows which coexist",
      .example = "experiments/reference_block/no_sliding.json -o out",
      .text = "runs every step of the sweep from the initial state of the file, and from the end of the previous step, "
              "upwards and downwards. Writes the strobe points to out/bifurcation.json and out/bifurcation.csv and "
              "prints the responses. In a grid there is one diagram for each combination of values of the entries "
              "after the first.",
      .python_notes =
          "A diagram for each combination of values of the other entries of the sweep. Raises InputError if there is "
          "no sweep, if its first entry takes values that are not numbers, or if the excitation is not periodic.",
      .python_example = R"(>>> import rocking
>>> found = rocking.bifurcation({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0}, "restitution": 0.9,
...     "horizon": {"transient_periods": 20, "sampled_periods": 20},
...     "sweep": [{"parameter": "/excitation/amplitude", "values": [2.0, 4.0]}]})
>>> [step.value for step in found.diagrams[0].steps if step.branch == "upwards"]
[2.0, 4.0])",
      .takes_seed = true,
      .has_long_table = true,
      .progress = "steps",
      .file = "bifurcation.json",
      .label = "points",
      .needs_folder = true,
      .document = bifurcation_document(),
  });
  return study;
}

}  // namespace rocking
