#include "standing.hpp"

#include <fmt/format.h>

#include "rocking/output/progress_note.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {
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

}  // namespace

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

}  // namespace rocking::program
