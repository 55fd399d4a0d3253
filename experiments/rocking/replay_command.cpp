#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "trajectory_output.hpp"

namespace rocking::program {
namespace {

struct ReplayRequest {
  std::string folder;
  RealisationKey key;
  TrajectoryOutput output;
  Loudness loudness;
};

ExitCode replay(const ReplayRequest& request) {
  expect_consistent(request.output, request.loudness);
  const auto& [condition_number, number] = request.key;
  const RunFolder folder(request.folder);
  const Store store = folder.open_store(sqlite::Access::read);
  const Experiment experiment = experiment_of(store.identity());
  const auto stored = condition_number < experiment.conditions.size() ? store.find(request.key) : std::nullopt;
  if (!stored) {
    static_cast<void>(folder.open_valid_store());  // in a damaged store a row may be there and not be found
    throw UsageError(fmt::format("{} contains no realisation {} of condition {}; both numbers start at 0",
                                 request.folder, number, condition_number));
  }
  const Condition& condition = experiment.conditions.at(condition_number);
  const RealisationResult result = realise(condition, experiment.seed, number);
  if (digest_of(result, number) != stored->digest) {
    print_notice(
        fmt::format("condition {}, realisation {}: this program gives a result different from the one stored in {}, "
                    "which rocking {} computed; this is {}",
                    condition_number, number, request.folder, store.identity().code, base::code_identity()));
    return ExitCode::check_failed;
  }
  const std::int64_t periods = std::int64_t{condition.horizon.transient_periods} + condition.horizon.sampled_periods;
  print_result(text_of(request.key, trajectory_of(condition, experiment.seed, number, periods), request.output));
  return ExitCode::done;
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  const auto request = std::make_shared<ReplayRequest>();
  CLI::App* command =
      app.add_subcommand("replay", "Print one realisation of a finished run, checked against its digest");
  command->footer(
      "Example: rocking replay out --condition 12 --realisation 3\n"
      "prints the same as `rocking trajectory`, from the folder of a run. The exit code is 1 if the bits differ from "
      "those of the run.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command->add_option("--condition", request->key.condition, "Number of the condition, from 0")
      ->required()
      ->check(whole_number(0, random::realisation_limit - 1))
      ->type_name("I");
  command->add_option("--realisation", request->key.realisation, "Number of the realisation, from 0")
      ->required()
      ->check(whole_number(0, random::realisation_limit - 1))
      ->type_name("K");
  add_trajectory_output(*command, request->output);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return replay(*request); }; });
}

}  // namespace rocking::program
