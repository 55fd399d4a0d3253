#include "rocking/studies/orbits/study.hpp"

#include <algorithm>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/many_parts.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/studies/orbits/orbits.hpp"

namespace rocking {
namespace {

/// The swept number over which orbits can be followed; absent if there is none.
std::optional<SweptNumber> followed_number(const Experiment& experiment) {
  if (experiment.canonical_text.empty()) return std::nullopt;
  auto swept = only_swept_number(experiment);
  return swept && can_be_continued(swept->pointer) ? swept : std::nullopt;
}

/// What is asked of branches. Throws where there are none.
BranchQuestion branch_question(const Experiment& experiment, const OrbitsQuestion& question) {
  const auto swept = followed_number(experiment);
  if (!swept) {
    refuse(question.from || question.to ? "from" : "branches", "",
           "are followed over the sweep of one number of the motion alone; the experiment has none");
  }
  const auto [least, greatest] = std::ranges::minmax(swept->values);
  const ParameterRange range{.low = question.from.value_or(least), .high = question.to.value_or(greatest)};
  if (!(range.low < range.high)) {
    refuse("from", base::shortest(range.low),
           "must be less than the upper end of the range of branches, " + base::shortest(range.high));
  }
  return {.conditions = condition_family(experiment, swept->pointer),
          .values = swept->values,
          .range = range,
          .most_points = question.most_points,
          .most_branches = question.most_branches};
}

/// Adds the orbits on branches at the conditions to those that are known.
FoundBranches followed(const Experiment& experiment, const OrbitsQuestion& question, base::StopRequest stop,
                       const std::function<void()>& on_point, std::vector<OrbitsOfCondition>& conditions) {
  BranchQuestion branches = branch_question(experiment, question);
  branches.on_point = on_point;
  return {.pointer = followed_number(experiment)->pointer,
          .range = branches.range,
          .most_points = branches.most_points,
          .study = branches_of(branches, conditions, stop)};
}

/// In their order; progress counts conditions.
std::vector<OrbitsOfCondition> orbits_of_conditions(const Experiment& experiment, int longest,
                                                    const OptionsOfExecution& asked) {
  std::vector<OrbitsOfCondition> found(experiment.conditions.size());
  std::uint64_t done = 0;
  const auto count = [&] {
    if (asked.options().on_progress) asked.options().on_progress(++done, found.size());
  };
  base::for_each_part({.threads = asked.options().threads, .stop = asked.stop(), .on_part = count}, found.size(),
                      [&](std::size_t i) {
                        found[i] = orbits_of(experiment.conditions[i], longest, asked.stop());
                        found[i].parameters = experiment.conditions[i].parameters;
                      });
  return found;
}

/// Whether an experiment sweeps one number of the motion, with several values, so that branches can be followed.
bool has_branches(const Experiment& experiment) {
  const auto swept = followed_number(experiment);
  return swept && std::ranges::min(swept->values) < std::ranges::max(swept->values);
}

}  // namespace

OrbitsQuestion checked(const Experiment& experiment, OrbitsQuestion question) {
  check_has_conditions(experiment);
  check_fields(question);
  check_orbits(experiment);
  const bool has_range = question.from || question.to;
  if (has_range && !question.branches) refuse("from", "", "limits branches, of which none are asked for");
  question.branches = question.branches && (has_range || has_branches(experiment));
  if (question.branches) static_cast<void>(branch_question(experiment, question));
  return question;
}

OrbitStudy orbits(const Experiment& experiment, const OrbitsQuestion& question, const Execution& execution) {
  const OrbitsQuestion asked = checked(experiment, question);
  const OptionsOfExecution how(execution);
  OrbitStudy study{.longest = asked.longest, .conditions = orbits_of_conditions(experiment, asked.longest, how)};
  if (!asked.branches) return study;
  std::uint64_t points = 0;
  const auto on_point = [&points, &how] {
    if (how.options().on_progress) how.options().on_progress(++points, 0);
  };
  study.branches = followed(experiment, asked, how.stop(), on_point, study.conditions);
  return study;
}

const StructType& fields_of(const OrbitsQuestion*) {
  using Type = OrbitsQuestion;
  static const StructType fields{
      "OrbitsQuestion",
      asked(field<&Type::longest>("longest", "Longest period that is searched from the grid, in excitation periods",
                                  Rule{.least = 1.0, .most = static_cast<double>(section::longest_period)}),
            {.names = "--periods", .letter = "N"}),
      asked(field<&Type::branches>("branches", "Follow the orbits over the swept parameter"),
            {.names = "--no-branches", .kind = FlagKind::off}),
      asked(
          field<&Type::from>("from", "Smallest value of the swept parameter for branches; default: that of the sweep"),
          {.names = "--from", .letter = "X", .excludes = "--no-branches"}),
      asked(field<&Type::to>("to", "Largest value of it; default: that of the sweep"),
            {.names = "--to", .letter = "X", .excludes = "--no-branches"}),
      asked(field<&Type::most_points>("most_points", "Largest number of points of a branch in each direction",
                                      Rule{.least = 2.0, .most = 1e6}),
            {.names = "--branch-points", .letter = "N"}),
      asked(
          field<&Type::most_branches>(
              "most_branches", "Largest number of branches; if there are more, the table and the key `complete` say so",
              Rule{.least = 1.0, .most = 1e5}),
          {.names = "--branches", .letter = "N"}),
  };
  return fields;
}

namespace {

void check(const Subject& subject, OrbitsQuestion& question) { question = checked(subject.experiment, question); }

std::string_view then(const OrbitsQuestion& question) { return question.branches ? "points of branches" : ""; }

Answer find(const Subject& subject, const OrbitsQuestion& question, const Circumstances& circumstances) {
  const OrbitStudy found = orbits(subject.experiment, question, circumstances.execution);
  return {.document = orbits_document().text(orbits_report(subject.experiment, found)),
          .table = table_of(found, circumstances.extent)};
}

std::vector<analysis::Figure> figures(const Json& document, std::span<const Json>) {
  const OrbitsReport report = orbits_document().read(document);
  if (!report.study.branches) return {};
  return {analysis::branch_figure(report)};
}

constexpr StudyFunctions<OrbitsQuestion> functions{.check = check, .find = find, .then = then, .figures = figures};

}  // namespace

const Study& orbits_study() {
  static const Study study = study_of<OrbitsQuestion, functions>({
      .name = "orbits",
      .sentence = "Find the periodic orbits, stable and unstable, and their multipliers",
      .example = "experiments/reference_block/no_sliding.json -o out",
      .text = "searches in each condition by Newton's method on the Poincare map, from the end of a run and from a "
              "grid of states. If one number is swept, follows the orbits over it, through folds, and locates their "
              "bifurcations. Writes the orbits to out/orbits.json and prints them. The excitation must be harmonic, "
              "and nothing may be random.",
      .python_notes = "Raises InputError if a condition is random or its excitation is not harmonic.",
      .python_example = R"(>>> import rocking
>>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
...     "horizon": {"transient_periods": 200, "sampled_periods": 60}}, periods=1)
>>> all(orbit.residual <= 1e-13 for orbit in found.conditions[0].orbits)
True)",
      .has_long_table = true,
      .progress = "conditions",
      .more_notice = "following branches, too; --no-branches omits them",
      .file = "orbits.json",
      .label = "orbits",
      .needs_folder = true,
      .document = orbits_document(),
      .without_figures = {"/branches", "", "are missing: a figure shows the branches of orbits",
                          "sweep one number of the motion, and omit --no-branches"},
  });
  return study;
}

}  // namespace rocking
