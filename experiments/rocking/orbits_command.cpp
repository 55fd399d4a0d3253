#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "exit_code.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/output/write_orbits.hpp"
#include "rocking/section/period.hpp"
#include "rocking/studies/orbits/bifurcation_curve.hpp"
#include "rocking/studies/orbits/branches.hpp"
#include "rocking/studies/orbits/orbits.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::program {
namespace {

struct OrbitsRequest {
  std::string file;
  std::string folder;
  std::uint64_t longest = default_longest_orbit;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
  bool without_branches = false;
  std::optional<double> from;  ///< of the range of branches; absent: the smallest swept value
  std::optional<double> to;    ///< likewise the largest one
  std::uint64_t branch_points = default_branch_points;
  std::uint64_t branches = default_branches;
  std::vector<std::string> second;  ///< pointers of the second parameter; empty: no curves
  std::optional<double> second_from;
  std::optional<double> second_to;
  std::uint64_t curve_points = default_curve_points;
};

/// Throws InputError, with the file and the line, where the experiment has no orbits.
void refuse_without_orbits(const Experiment& experiment, const std::string& file) {
  try {
    check_orbits(experiment);
  } catch (const base::InputError& error) {
    throw located(error, read_file(file), file);
  }
}

std::optional<std::vector<OrbitsOfCondition>> search(const Experiment& experiment, const OrbitsRequest& request) {
  Progress progress(suitable_progress_style(request.execution.loudness), "conditions");
  RunOptions options;
  options.threads = request.execution.threads;
  options.stop_requested = &stop_on_interrupt();
  options.on_progress = [&](std::uint64_t done, std::uint64_t all) { progress.show(done, all); };
  return orbits(experiment, static_cast<int>(request.longest), options);
}

/// What is asked for; absent if there are no branches. Throws UsageError if a range is given and there are none in it.
std::optional<BranchQuestion> branch_question(const Experiment& experiment, const OrbitsRequest& request) {
  const auto swept = only_swept_number(experiment);
  const bool has_range = request.from || request.to;
  if (!swept || !can_be_continued(swept->pointer) || request.without_branches) {
    if (!has_range) return std::nullopt;
    throw UsageError(
        "--from and --to limit branches, but none are followed: sweep one number of the motion, and omit "
        "--no-branches");
  }
  BranchQuestion question{.conditions = condition_family(experiment, swept->pointer),
                          .values = swept->values,
                          .range = {},
                          .most_points = request.branch_points,
                          .most_branches = request.branches};
  const auto [least, greatest] = std::ranges::minmax(question.values);
  question.range = {.low = request.from.value_or(least), .high = request.to.value_or(greatest)};
  if (question.range.low < question.range.high) return question;
  if (!has_range) return std::nullopt;
  throw UsageError(fmt::format("--from {} --to {}: the range of branches must begin below its end", question.range.low,
                               question.range.high));
}

std::optional<FoundBranches> branches(const Experiment& experiment, const std::optional<BranchQuestion>& question,
                                      const OrbitsRequest& request, std::vector<OrbitsOfCondition>& conditions) {
  if (!question) return std::nullopt;
  if (!request.execution.loudness.quiet) print_notice("following branches; --no-branches omits them");
  return FoundBranches{.pointer = experiment.conditions.front().parameters.front().pointer,
                       .range = question->range,
                       .most_points = request.branch_points,
                       .study = branches_of(*question, conditions, &stop_on_interrupt())};
}

/// The second parameter and its range, without the curves; absent if none is asked for. Throws UsageError or
/// base::InputError if they cannot be followed.
std::optional<FoundCurves> curve_request(const Experiment& experiment, const std::optional<BranchQuestion>& question,
                                         const OrbitsRequest& request) {
  if (request.second.empty()) {
    if (!request.second_from && !request.second_to) return std::nullopt;
    throw UsageError("--second-from and --second-to are the range of --second-parameter, which is missing");
  }
  if (!question) throw UsageError("--second-parameter: no branches are followed; sweep one number of the motion");
  if (!request.second_from || !request.second_to || !(*request.second_from < *request.second_to)) {
    throw UsageError("--second-parameter needs a range: --second-from X --second-to Y, with X below Y");
  }
  for (const std::string& pointer : request.second) {
    if (can_be_continued(pointer)) continue;
    throw UsageError(
        fmt::format("--second-parameter {}: no real number on which the motion depends continuously; give for example "
                    "/excitation/frequency_ratio or /friction/static",
                    pointer));
  }
  FoundCurves found{.pointers = request.second,
                    .value = second_parameter(experiment, request.second).value,
                    .range = {.low = *request.second_from, .high = *request.second_to},
                    .most_points = request.curve_points,
                    .curves = {}};
  if (found.value >= found.range.low && found.value <= found.range.high) return found;
  throw UsageError(fmt::format("--second-from {} --second-to {}: the value of the experiment, {}, must be between them",
                               found.range.low, found.range.high, found.value));
}

void follow_curves(const Experiment& experiment, const OrbitsRequest& request, const FoundBranches& branches,
                   FoundCurves& found) {
  if (!request.execution.loudness.quiet) print_notice("following bifurcations over the second parameter");
  const SecondParameter second = second_parameter(experiment, found.pointers);
  const CurveQuestion question{.conditions = condition_plane(experiment, branches.pointer, second),
                               .ranges = {branches.range, found.range},
                               .second = found.value,
                               .most_points = found.most_points};
  found.curves = bifurcation_curves(question, branches.study, &stop_on_interrupt());
}

ExitCode orbits(const OrbitsRequest& request) {
  const Experiment experiment = load_experiment(request.file, {});
  refuse_without_orbits(experiment, request.file);  // before any file is written
  const std::optional<BranchQuestion> question = branch_question(experiment, request);
  std::optional<FoundCurves> curves = curve_request(experiment, question, request);
  const std::filesystem::path file = std::filesystem::path(request.folder) / "orbits.json";
  expect_free(file, request.overwrite);
  ensure_writable(request.folder);
  auto conditions = search(experiment, request);
  const auto explain_stop = [&request] {
    print_notice(fmt::format("interrupted; nothing was written. `rocking orbits {} -o {}` starts again", request.file,
                             request.folder));
    return ExitCode::interrupted;
  };
  if (!conditions) return explain_stop();
  FoundOrbits found{.experiment = &experiment, .longest = static_cast<int>(request.longest), .conditions = {}};
  try {
    found.branches = branches(experiment, question, request, *conditions);
    if (curves) follow_curves(experiment, request, *found.branches, *curves);
    found.curves = std::move(curves);
  } catch (const base::Stopped&) {
    return explain_stop();
  }
  found.conditions = std::move(*conditions);
  const std::string text = orbits_text(found);
  expect_free(file, request.overwrite);
  write_atomically(file, text);
  const std::string title = experiment.title.empty() ? "" : experiment.title + "\n\n";
  const std::string where = fmt::format("orbits: {}\n", file.string());
  print_result(request.execution.loudness.json ? text : base::printable(title + orbits_table(found) + where));
  return ExitCode::done;
}

}  // namespace

void add_orbits(CLI::App& app, Action& action) {
  const auto request = std::make_shared<OrbitsRequest>();
  CLI::App* command =
      app.add_subcommand("orbits", "Find the periodic orbits, stable and unstable, and their multipliers");
  command->footer(
      "Example: rocking orbits experiments/reference_block/no_sliding.json -o out\n"
      "searches in each condition by Newton's method on the Poincare map, from the end of a run and from a grid of "
      "states.\n"
      "If one number is swept, follows the orbits over it, through folds, and locates their bifurcations.\n"
      "Writes the orbits to out/orbits.json and prints them. The excitation must be harmonic, and nothing may be "
      "random.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON)")->required();
  command->add_option("-o,--output", request->folder, "Folder for the results; created if necessary")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--periods", request->longest,
                   "Longest period that is searched from the grid, in excitation periods")
      ->check(whole_number(1, section::longest_period))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--no-branches", request->without_branches, "Do not follow the orbits over the swept parameter");
  command->add_option("--from", request->from, "Smallest value of the swept parameter for branches; else of the sweep")
      ->type_name("X");
  command->add_option("--to", request->to, "Largest value of it; else of the sweep")->type_name("X");
  command->add_option("--branch-points", request->branch_points, "Largest number of points of a branch")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--branches", request->branches, "Largest number of branches")
      ->check(whole_number(1, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--second-parameter", request->second,
                   "JSON pointer of a second number, over which folds, doublings and losses of symmetry are followed; "
                   "of several pointers, the numbers at the others keep their ratio to the first")
      ->type_name("POINTER");
  command->add_option("--second-from", request->second_from, "Smallest value of the second number")->type_name("X");
  command->add_option("--second-to", request->second_to, "Largest value of it")->type_name("X");
  command
      ->add_option("--curve-points", request->curve_points,
                   "Largest number of points of such a curve in each direction")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  add_threads(*command, request->execution);
  command->add_flag("--overwrite", request->overwrite, "Replace the file of this name in the folder");
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return orbits(*request); }; });
}

}  // namespace rocking::program
