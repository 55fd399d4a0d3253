#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "exit_code.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct OrbitsCommand {
  std::string file;
  std::string folder;
  OrbitsRequest orbits{.branches = true};
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
};

/// The same with the flag in the place of an argument of the library, or with the line of the experiment file.
base::InputError explained(const base::InputError& error, const std::string& file) {
  base::Problem problem = error.problems().front();
  if (problem.place.starts_with('/')) return located(error, read_file(file), file);
  if (problem.place == "from" || problem.place == "branches") problem.place = "--from";
  if (problem.place == "second") problem.place = "--second-parameter";
  if (problem.place == "second_from") problem.place = "--second-from";
  return base::InputError(problem);
}

/// What is asked, of an experiment that may have no branches. Throws before any file is written.
OrbitsRequest checked(const Experiment& experiment, const OrbitsCommand& command) {
  OrbitsRequest request = command.orbits;
  const bool has_range = request.from || request.to;
  if (!has_range) request.branches = request.branches && has_branches(experiment);
  if (has_range && !request.branches) throw UsageError("--from and --to limit branches; omit --no-branches");
  if (request.second.empty() && (request.second_from || request.second_to)) {
    throw UsageError("--second-from and --second-to are the range of --second-parameter, which is missing");
  }
  try {
    check_request(experiment, request);
  } catch (const base::InputError& error) {
    throw explained(error, command.file);
  }
  return request;
}

OrbitStudy search(const Experiment& experiment, const OrbitsRequest& request, const ExecutionOptions& execution) {
  if (request.branches && !execution.loudness.quiet) {
    print_notice("following branches, too; --no-branches omits them");
  }
  Progress progress(suitable_progress_style(execution.loudness), "conditions");
  return rocking::orbits(experiment, request, watched(execution, progress));
}

ExitCode orbits(const OrbitsCommand& command) {
  const Experiment experiment = load_experiment(command.file, {});
  const OrbitsRequest request = checked(experiment, command);
  const std::filesystem::path file = std::filesystem::path(command.folder) / "orbits.json";
  expect_free(file, command.overwrite);
  ensure_writable(command.folder);
  const OrbitStudy study = search(experiment, request, command.execution);
  const std::string text = orbits_text(experiment, study);
  expect_free(file, command.overwrite);
  write_atomically(file, text);
  const std::string title = experiment.title.empty() ? "" : experiment.title + "\n\n";
  const std::string where = fmt::format("orbits: {}\n", file.string());
  print_result(command.execution.loudness.json ? text : base::printable(title + orbits_table(study) + where));
  return ExitCode::done;
}

}  // namespace

void add_orbits(CLI::App& app, Action& action) {
  const auto request = std::make_shared<OrbitsCommand>();
  OrbitsRequest& orbits_asked = request->orbits;
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
      ->add_option("--periods", orbits_asked.longest,
                   "Longest period that is searched from the grid, in excitation periods")
      ->check(whole_number(1, section::longest_period))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag_callback(
      "--no-branches", [&orbits_asked] { orbits_asked.branches = false; },
      "Do not follow the orbits over the swept parameter");
  command
      ->add_option("--from", orbits_asked.from, "Smallest value of the swept parameter for branches; else of the sweep")
      ->type_name("X");
  command->add_option("--to", orbits_asked.to, "Largest value of it; else of the sweep")->type_name("X");
  command->add_option("--branch-points", orbits_asked.most_points, "Largest number of points of a branch")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--branches", orbits_asked.most_branches, "Largest number of branches")
      ->check(whole_number(1, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--second-parameter", orbits_asked.second,
                   "JSON pointer of a second number, over which folds, doublings and losses of symmetry are followed; "
                   "of several pointers, the numbers at the others keep their ratio to the first")
      ->type_name("POINTER");
  command->add_option("--second-from", orbits_asked.second_from, "Smallest value of the second number")->type_name("X");
  command->add_option("--second-to", orbits_asked.second_to, "Largest value of it")->type_name("X");
  command
      ->add_option("--curve-points", orbits_asked.most_curve_points,
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
