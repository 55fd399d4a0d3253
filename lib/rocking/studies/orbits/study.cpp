#include "rocking/studies/orbits/study.hpp"

#include "rocking/section/classification.hpp"
#include "rocking/studies/orbits/branch_figure.hpp"
#include "rocking/studies/orbits/curve_figure.hpp"
#include "rocking/studies/orbits/result.hpp"
#include "rocking/studies/orbits/table.hpp"

namespace rocking {

const StructType& fields_of(const OrbitsRequest*) {
  using Type = OrbitsRequest;
  static const StructType fields{
      "OrbitsRequest",
      asked(field<&Type::longest>("longest", "Longest period that is searched from the grid, in excitation periods",
                                  Rule{.least = 1.0, .most = static_cast<double>(section::longest_period)}),
            {.names = "--periods", .letter = "N"}),
      asked(field<&Type::branches>("branches", "Follow the orbits over the swept parameter"),
            {.names = "--no-branches", .kind = FlagKind::off}),
      asked(
          field<&Type::from>("from", "Smallest value of the swept parameter for branches; default: that of the sweep"),
          {.names = "--from", .letter = "X"}, "branch_range[0]"),
      asked(field<&Type::to>("to", "Largest value of it; default: that of the sweep"), {.names = "--to", .letter = "X"},
            "branch_range[1]"),
      asked(field<&Type::most_points>("most_points", "Largest number of points of a branch in each direction",
                                      Rule{.least = 2.0, .most = 1e6}),
            {.names = "--branch-points", .letter = "N"}),
      asked(
          field<&Type::most_branches>(
              "most_branches", "Largest number of branches; if there are more, the table and the key `complete` say so",
              Rule{.least = 1.0, .most = 1e5}),
          {.names = "--branches", .letter = "N"}),
      asked(field<&Type::second>(
                "second",
                "JSON pointer of a second number, over which folds, doublings and losses of symmetry are followed; "
                "of several pointers, the numbers at the others keep their ratio to the first"),
            {.names = "--second-parameter", .letter = "POINTER..."}, "second_parameter"),
      asked(field<&Type::second_from>("second_from",
                                      "Smallest value of the second number; required with --second-parameter"),
            {.names = "--second-from", .letter = "X"}, "second_range[0]"),
      asked(field<&Type::second_to>("second_to", "Largest value of it; required with --second-parameter"),
            {.names = "--second-to", .letter = "X"}, "second_range[1]"),
      asked(field<&Type::most_curve_points>("most_curve_points",
                                            "Largest number of points of such a curve in each direction",
                                            Rule{.least = 1.0, .most = 1e6}),
            {.names = "--curve-points", .letter = "N"}),
  };
  return fields;
}

namespace {

struct OrbitsQuestion {
  OrbitsRequest request = {};
  bool where_possible = false;  ///< branches are followed where there is something to follow
};

const StructType& fields_of(const OrbitsQuestion*) {
  static const StructType fields{"OrbitsQuestion", inlined<&OrbitsQuestion::request>()};
  return fields;
}

void check(const Subject& subject, OrbitsQuestion& question) {
  OrbitsRequest& request = question.request;
  const bool has_range = request.from || request.to;
  if (has_range && !request.branches) throw UnfitQuestion("--from and --to limit branches; omit --no-branches");
  if (question.where_possible && !has_range) request.branches = request.branches && has_branches(subject.experiment);
  if (request.second.empty() && (request.second_from || request.second_to)) {
    throw UnfitQuestion("--second-from and --second-to are the range of --second-parameter, which is missing");
  }
  check_request(subject.experiment, request);
}

std::string_view then(const OrbitsQuestion& question) { return question.request.branches ? "points of branches" : ""; }

Answer find(const Subject& subject, const OrbitsQuestion& question, const Circumstances& circumstances) {
  const OrbitStudy found = orbits(subject.experiment, question.request, circumstances.execution);
  return {.document = orbits_text(subject.experiment, found), .table = table_of(found, circumstances.extent)};
}

std::vector<analysis::Figure> figures(const Json& document, std::span<const Json>) {
  const OrbitsReport report = orbits_document().read(document);
  if (!report.study.branches) return {};
  std::vector<analysis::Figure> drawn{analysis::branch_figure(report)};
  if (report.study.curves && !report.study.curves->curves.empty()) drawn.push_back(analysis::curve_figure(report));
  return drawn;
}

constexpr StudyFunctions<OrbitsQuestion> functions{
    .of_command = [] { return OrbitsQuestion{.request = {.branches = true}, .where_possible = true}; },
    .check = check,
    .find = find,
    .then = then,
    .figures = figures};

}  // namespace

const Study& orbits_study() {
  static const Study study = study_of<OrbitsQuestion, functions>({
      .name = "orbits",
      .sentence = "Find the periodic orbits, stable and unstable, and their multipliers",
      .example = "experiments/reference_block/no_sliding.json -o out",
      .text =
          "searches in each condition by Newton's method on the Poincare map, from the end of a run and from a grid "
          "of states. If one number is swept, follows the orbits over it, through folds, and locates their "
          "bifurcations. Writes the orbits to out/orbits.json and prints them. The excitation must be harmonic, and "
          "nothing may be random.",
      .python_notes = "Raises InputError if a condition is random or its excitation is not harmonic.",
      .python_example = R"(>>> import rocking
>>> found = rocking.orbits({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 4.0, "frequency_ratio": 10.0}, "restitution": 0.9,
...     "horizon": {"transient_periods": 200, "sampled_periods": 60}}, longest=1)
>>> all(orbit.residual <= 1e-13 for orbit in found.conditions[0].orbits)
True)",
      .has_long_table = true,
      .progress = "conditions",
      .more_notice = "following branches, too; --no-branches omits them",
      .file = "orbits.json",
      .label = "orbits",
      .needs_folder = true,
      .document = orbits_document(),
      .without_figures = {.place = "/branches",
                          .value = "",
                          .reason = "are missing: a figure shows the branches of orbits",
                          .remedy = "sweep one number of the motion, and omit --no-branches",
                          .where = {}},
  });
  return study;
}

}  // namespace rocking
