#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/text/number_text.hpp"
#include "standing.hpp"
#include "study_file.hpp"

namespace rocking::program {
namespace {

struct StatusRequest {
  std::string folder;
  Loudness loudness;
};

std::string to_text(const StatusRequest& request, const Standing& standing) {
  const auto [done, all] = standing.realisations;
  const double share = all == 0 ? 100.0 : 100.0 * static_cast<double>(done) / static_cast<double>(all);
  std::string text = fmt::format("{}: {}{}\n", request.folder, standing.state,
                                 standing.part.empty() ? "" : ", shard " + standing.part);
  text += fmt::format("done     {} of {} realisations ({:.1f} %)\n", done, all, share);
  text += fmt::format("missing  {}\nfailed   {}\n", standing.missing(), standing.failed);
  if (standing.replaces) text += "the earlier run in this folder is kept until this one is complete\n";
  if (standing.rate > 0.0) {
    text += fmt::format("rate     {:.3g}/s\nto go    {}\n", standing.rate,
                        duration_in_words(static_cast<double>(standing.missing()) / standing.rate));
  }
  if (standing.state == "stopped")
    text += fmt::format("`rocking resume {}` continues the run\n", shell_word(request.folder));
  return text;
}

std::vector<Fact> facts_of(const Standing& standing) {
  std::vector<Fact> facts{{"state", standing.state},
                          {"done", standing.realisations.done},
                          {"all", standing.realisations.all},
                          {"missing", standing.missing()},
                          {"failed", standing.failed}};
  if (!standing.part.empty()) facts.push_back({"shard", standing.part});
  if (standing.replaces) facts.push_back({"replaces_earlier_run", true});
  if (standing.rate > 0.0) {
    facts.push_back({"realisations_per_s", standing.rate});
    facts.push_back({"to_go_s", static_cast<double>(standing.missing()) / standing.rate});
  }
  return facts;
}

ExitCode status(const StatusRequest& request) {
  RunFolder folder(request.folder);
  const Standing standing = standing_of(folder);
  print_study(request.loudness, facts_text(facts_of(standing)), to_text(request, standing));
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
