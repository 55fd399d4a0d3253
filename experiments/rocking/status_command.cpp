#include <memory>
#include <string>

#include "output.hpp"
#include "program.hpp"
#include "rocking/api/checks.hpp"
#include "study_file.hpp"

namespace rocking::program {
namespace {

struct StatusRequest {
  std::string folder;
  Loudness loudness;
};

ExitCode status(const StatusRequest& request) {
  const RunStatus found = status_of(request.folder);
  print_study(request.loudness, describe_as_json(found), describe(found, request.folder));
  return ExitCode::done;
}

}  // namespace

void add_status(CLI::App& app, Action& action) {
  const auto request = std::make_shared<StatusRequest>();
  CLI::App* command = app.add_subcommand("status", "Print the progress of a run, also while it is in progress");
  command->footer(
      "Example: rocking status out\n"
      "prints the numbers of finished, missing and failed realisations (failed: the model has no solution, or a limit "
      "on the work was reached); while another `rocking` is working in out, also its rate and the remaining time. It "
      "only reads.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return status(*request); }; });
}

}  // namespace rocking::program
