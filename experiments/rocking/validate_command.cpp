#include <memory>

#include <fmt/format.h>

#include "arguments.hpp"
#include "before_run.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "program.hpp"
#include "rocking/rocking.hpp"

namespace rocking::program {
namespace {

struct ValidateRequest {
  std::string file;
  Overrides overrides;
  Loudness loudness;
};

ExitCode validate(const ValidateRequest& request) {
  try {
    const ExperimentText source = load_experiment_text(request.file);
    const Experiment experiment = load_experiment(source, request.overrides);
    if (request.loudness.json) {
      print_result(describe_as_json(experiment));
      if (!request.loudness.quiet) tell(findings_before_run(experiment));
    } else if (!request.loudness.quiet) {
      tell_ground_motion_notes(experiment);
      const Plan plan = plan_of(experiment, {.threads = available_threads(), .shard = {}});
      print_text(fmt::format("{}: valid: {}\n{}{}", source.name, describe(plan), describe_block(experiment),
                             checked_text(experiment)));
    }
    return ExitCode::done;
  } catch (const base::InputError& error) {
    if (!request.loudness.json) throw;
    print_result(describe_as_json(error));
    return ExitCode::bad_input;
  }
}

}  // namespace

void add_validate(CLI::App& app, Action& action) {
  const auto request = std::make_shared<ValidateRequest>();
  CLI::App* command = app.add_subcommand("validate", "Check an experiment file without simulating");
  command->footer(
      "Example: rocking validate my-experiment.json\n"
      "prints all problems together, each with its place, value and remedy, and warns of what is valid but suspicious: "
      "units, a squat block, random numbers that are clamped. With --json it prints the experiment with every default "
      "written out.");
  command->add_option("FILE", request->file, "Experiment file (JSON); -: standard input")->required();
  add_skip_unreadable(*command, request->overrides);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return validate(*request); }; });
}

}  // namespace rocking::program
