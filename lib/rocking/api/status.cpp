#include <vector>

#include "rocking/api/checks.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/progress_note.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

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

double seconds_to_go(const RunStatus& status) { return static_cast<double>(status.missing()) / status.rate; }

}  // namespace

RunStatus status_of(const std::filesystem::path& path) {
  RunFolder folder(path);
  const bool running = folder.is_at_work();
  if (folder.has_replacement()) folder.enter_replacement();
  // The running process checked the store when it started.
  const Store store = running ? folder.open_store(sqlite::Access::read) : folder.open_valid_store();
  RunStatus found;
  found.replaces = folder.is_replacement();
  if (const auto& shard = store.identity().shard) {
    found.part = std::to_string(shard->part) + '/' + std::to_string(shard->parts);
  }
  const Completeness realisations = completeness(experiment_of(store.identity()), store);
  found.done = realisations.done;
  found.all = realisations.all;
  store.for_each(
      [&](const RealisationKey&, const Summary& summary) { found.failed += has_no_answer(summary) ? 1 : 0; });
  const bool complete = found.missing() == 0 && !found.replaces && (folder.has_report() || !found.part.empty());
  found.state = running ? "running" : complete ? "finished" : "stopped";
  if (running) found.rate = rate_of(folder);
  return found;
}

std::string describe(const RunStatus& status, const std::filesystem::path& folder) {
  const double share =
      status.all == 0 ? 100.0 : 100.0 * static_cast<double>(status.done) / static_cast<double>(status.all);
  std::string text = folder.string() + ": " + status.state + (status.part.empty() ? "" : ", shard " + status.part) +
                     "\ndone     " + std::to_string(status.done) + " of " + std::to_string(status.all) +
                     " realisations (" + fixed_point(share, 1) + " %)\nmissing  " + std::to_string(status.missing()) +
                     "\nfailed   " + std::to_string(status.failed) + '\n';
  if (status.replaces) text += "the earlier run in this folder is kept until this one is complete\n";
  if (status.rate > 0.0) {
    text +=
        "rate     " + significant(status.rate, 3) + "/s\nto go    " + duration_in_words(seconds_to_go(status)) + '\n';
  }
  if (status.state == "stopped") text += "`rocking resume " + shell_word(folder.string()) + "` continues the run\n";
  return text;
}

std::string describe_as_json(const RunStatus& status) {
  std::vector<Fact> facts{{"state", status.state},
                          {"done", status.done},
                          {"all", status.all},
                          {"missing", status.missing()},
                          {"failed", status.failed}};
  if (!status.part.empty()) facts.push_back({"shard", status.part});
  if (status.replaces) facts.push_back({"replaces_earlier_run", true});
  if (status.rate > 0.0) {
    facts.push_back({"realisations_per_s", status.rate});
    facts.push_back({"to_go_s", seconds_to_go(status)});
  }
  return facts_text(facts);
}

}  // namespace rocking
