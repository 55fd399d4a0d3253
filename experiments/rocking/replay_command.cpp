#include <memory>
#include <string>

#include "arguments.hpp"
#include "output.hpp"
#include "program.hpp"
#include "rocking/rocking.hpp"

namespace rocking::program {
namespace {

struct ReplayRequest {
  std::string folder;
  TrajectoryRequest realisation;
  TrajectoryOutput output;
  Loudness loudness;
};

ExitCode replay(const ReplayRequest& request) {
  expect_consistent(request.output, request.loudness);
  try {
    const Trajectory found = rocking::replay(request.folder, request.realisation);
    print_result(text_of(request.realisation, found, request.output));
    return ExitCode::done;
  } catch (const DifferentBits& error) {
    print_notice(error.what());
    return ExitCode::check_failed;
  }
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
  add_realisation(*command, request->realisation, Naming::required);
  add_trajectory_output(*command, request->output);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return replay(*request); }; });
}

}  // namespace rocking::program
