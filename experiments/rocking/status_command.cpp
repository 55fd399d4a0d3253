#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/progress_note.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct StatusRequest {
  std::string folder;
  Loudness loudness;
};

/// State of a run.
struct Standing {
  std::string state;  ///< running, stopped or finished
  std::string part;   ///< `2/5` of a shard; empty: the whole
  Completeness realisations;
  std::uint64_t failed = 0;  ///< of those that are done: stopped, or ended by Painleve's paradox
  bool replaces = false;     ///< will replace an earlier run in the folder
  double rate = 0.0;         ///< realisations per second of the active run; 0 if none is active or it has just started

  [[nodiscard]] std::uint64_t missing() const { return realisations.all - realisations.done; }
};

double rate_of(const RunFolder& folder) {
  if (!std::filesystem::exists(folder.progress_path())) return 0.0;
  const auto note = read_progress_note(read_file(folder.progress_path()));
  if (!note || note->elapsed_s <= 0.0) return 0.0;
  return static_cast<double>(note->done - note->done_before) / note->elapsed_s;
}

bool has_no_answer(const Summary& summary) {
  return summary.termination == dynamics::Termination::painleve ||
         summary.termination == dynamics::Termination::stopped;
}

Standing standing_of(RunFolder& folder) {
  const bool running = folder.is_at_work();
  if (folder.has_replacement()) folder.enter_replacement();
  // The running process checked the store when it started.
  const Store store = running ? folder.open_store(sqlite::Access::read) : folder.open_valid_store();
  Standing standing;
  standing.replaces = folder.is_replacement();
  if (const auto& shard = store.identity().shard) standing.part = fmt::format("{}/{}", shard->part, shard->parts);
  standing.realisations = completeness(experiment_of(store.identity()), store);
  store.for_each(
      [&](const RealisationKey&, const Summary& summary) { standing.failed += has_no_answer(summary) ? 1 : 0; });
  const bool complete =
      standing.missing() == 0 && !standing.replaces && (folder.has_report() || !standing.part.empty());
  standing.state = running ? "running" : complete ? "finished" : "stopped";
  if (running) standing.rate = rate_of(folder);
  return standing;
}

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
  if (standing.state == "stopped") text += fmt::format("`rocking resume {}` continues the run\n", request.folder);
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
  print_result(request.loudness.json ? facts_text(facts_of(standing)) : base::printable(to_text(request, standing)));
  return ExitCode::done;
}

}  // namespace

void add_status(CLI::App& app, Action& action) {
  const auto request = std::make_shared<StatusRequest>();
  CLI::App* command = app.add_subcommand("status", "Print the progress of a run, also while it is in progress");
  command->footer(
      "Example: rocking status out\n"
      "prints the numbers of finished, missing and failed realisations (failed: the model has no solution, or a limit "
      "on the\n"
      "work was reached); while another `rocking` is working in out, also its rate and the remaining time. It only "
      "reads.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return status(*request); }; });
}

}  // namespace rocking::program
