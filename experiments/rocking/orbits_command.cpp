#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "exit_code.hpp"
#include "experiment_argument.hpp"
#include "machine.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/orbits_table.hpp"
#include "rocking/section/classification.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct OrbitsCommand {
  std::string experiment;
  StudyFile file{"orbits.json", "orbits"};
  OrbitsRequest orbits{.branches = true};
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// What is asked, of an experiment that may have no branches. Throws before any file is written.
OrbitsRequest checked(const Experiment& experiment, const ExperimentText& source, OrbitsRequest request) {
  const bool has_range = request.from || request.to;
  if (!has_range) request.branches = request.branches && has_branches(experiment);
  if (has_range && !request.branches) throw UsageError("--from and --to limit branches; omit --no-branches");
  if (request.second.empty() && (request.second_from || request.second_to)) {
    throw UsageError("--second-from and --second-to are the range of --second-parameter, which is missing");
  }
  try {
    check_source(source, [&] { check_request(experiment, request); });
  } catch (const base::InputError& error) {
    throw with_flags(error, {{"from", "--from"},
                             {"branches", "--from"},
                             {"second", "--second-parameter"},
                             {"second_from", "--second-from"}});
  }
  return request;
}

ExitCode orbits(OrbitsCommand& command) {
  const ExperimentText source = load_experiment_text(command.experiment);
  const Experiment experiment = load_experiment(source);
  const OrbitsRequest request = checked(experiment, source, command.orbits);
  command.file.prepare();
  if (request.branches && !command.execution.loudness.quiet) {
    print_notice("following branches, too; --no-branches omits them");
  }
  Progress progress(suitable_progress_style(command.execution.loudness), "conditions",
                    request.branches ? "points of branches" : "");
  const OrbitStudy study = rocking::orbits(experiment, request, watched(command.execution, progress));
  const std::string text = orbits_text(experiment, study);
  deliver_study(command.execution.loudness, text, heading(experiment) + table_of(study, command.execution.extent),
                [&] { return command.file.write(text); });
  return ExitCode::done;
}

CLI::Option* add_count(CLI::App& command, const char* name, std::uint64_t& count, std::uint64_t most,
                       const char* description) {
  return command.add_option(name, count, description)
      ->check(whole_number(1, most))
      ->capture_default_str()
      ->type_name("N");
}

CLI::Option* add_limit(CLI::App& command, const char* name, std::optional<double>& limit, const char* description) {
  return command.add_option(name, limit, description)->type_name("X");
}

void add_request(CLI::App& command, OrbitsRequest& asked) {
  command
      .add_option("--periods", asked.longest, "Longest period that is searched from the grid, in excitation periods")
      ->check(whole_number(1, section::longest_period))
      ->capture_default_str()
      ->type_name("N");
  command.add_flag_callback(
      "--no-branches", [&asked] { asked.branches = false; }, "Do not follow the orbits over the swept parameter");
  add_limit(command, "--from", asked.from, "Smallest value of the swept parameter for branches; else of the sweep");
  add_limit(command, "--to", asked.to, "Largest value of it; else of the sweep");
  add_count(command, "--branch-points", asked.most_points, 1'000'000, "Largest number of points of a branch");
  add_count(command, "--branches", asked.most_branches, 100'000, "Largest number of branches");
  command
      .add_option("--second-parameter", asked.second,
                  "JSON pointer of a second number, over which folds, doublings and losses of symmetry are followed; "
                  "of several pointers, the numbers at the others keep their ratio to the first")
      ->type_name("POINTER");
  add_limit(command, "--second-from", asked.second_from, "Smallest value of the second number");
  add_limit(command, "--second-to", asked.second_to, "Largest value of it");
  add_count(command, "--curve-points", asked.most_curve_points, 1'000'000,
            "Largest number of points of such a curve in each direction");
}

}  // namespace

void add_orbits(CLI::App& app, Action& action) {
  const auto request = std::make_shared<OrbitsCommand>();
  CLI::App* command =
      app.add_subcommand("orbits", "Find the periodic orbits, stable and unstable, and their multipliers");
  command->footer(
      "Example: rocking orbits experiments/reference_block/no_sliding.json -o out\n"
      "searches in each condition by Newton's method on the Poincare map, from the end of a run and from a grid of "
      "states. If one number is swept, follows the orbits over it, through folds, and locates their bifurcations. "
      "Writes the orbits to out/orbits.json and prints them. The excitation must be harmonic, and nothing may be "
      "random.");
  add_experiment(*command, request->experiment);
  request->file.add_to(*command, true);
  add_request(*command, request->orbits);
  add_threads(*command, request->execution);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return orbits(*request); }; });
}

}  // namespace rocking::program
