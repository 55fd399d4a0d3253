#include "joining.hpp"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/store/difference.hpp"
#include "rocking/store/merge.hpp"
#include "rocking/store/results_version.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

struct Source {
  std::string name;
  Store store;
};

std::vector<Source> open_sources(const MergeRequest& request) {
  std::vector<Source> sources;
  for (const std::string& name : request.shards) {
    sources.push_back({name, RunFolder(name).open_valid_store()});
  }
  return sources;
}

// The report of the whole names this program, so its rows must have the bits that this program gives.
void expect_current_results(const Source& source) {
  const Identity& identity = source.store.identity();
  if (identity.results == results_version) return;
  throw InTheWay(
      fmt::format("{}: was run by rocking {}, and this is {}, which may give other results; merge with that "
                  "program",
                  source.name, identity.code, base::code_identity()));
}

void check_same_run(const Source& first, const Source& other) {
  if (other.store.identity().experiment != first.store.identity().experiment) {
    throw InTheWay(fmt::format("{}: belongs to another experiment than {} (a setting or the seed differs)", other.name,
                               first.name));
  }
  expect_current_results(other);
}

ExitCode explain_conflicts(const Source& source, const std::vector<Difference>& conflicts) {
  const Difference& first = conflicts.front();
  print_notice(fmt::format(
      "{}: {} different from an earlier folder; the first: condition {}, realisation {} ({}). Nothing was "
      "written. `rocking verify` shows which folder is right",
      source.name, conflicts.size() == 1 ? "1 realisation is" : counted(conflicts.size(), "realisation") + " are",
      first.key.condition, first.key.realisation, fmt::join(first.fields, ", ")));
  return ExitCode::check_failed;
}

/// Discards an unfinished replacement of the earlier run, unless keep() was called.
class DiscardUnlessJoined {
 public:
  explicit DiscardUnlessJoined(RunFolder& folder) : folder_(&folder) {}
  DiscardUnlessJoined(const DiscardUnlessJoined&) = delete;
  DiscardUnlessJoined& operator=(const DiscardUnlessJoined&) = delete;
  ~DiscardUnlessJoined() {
    if (folder_ == nullptr) return;
    try {
      folder_->discard_replacement();
    } catch (const std::exception&) {
      // It stays in its subfolder, where the next merge removes it.
    }
  }
  void keep() { folder_ = nullptr; }

 private:
  RunFolder* folder_;
};

// The whole takes at most as much disk space as its parts.
void expect_room(const RunFolder& folder, const MergeRequest& request) {
  if (!request.overwrite && (folder.has_store() || folder.has_report() || folder.has_replacement())) {
    throw InTheWay(request.folder +
                   ": already contains a run; choose another folder for the whole, or add --overwrite");
  }
  std::uintmax_t need = 0;
  for (const std::string& shard : request.shards) need += std::filesystem::file_size(RunFolder(shard).store_path());
  folder.expect_room(need);
}

void expect_shards_elsewhere(const MergeRequest& request) {
  for (const std::string& shard : request.shards) {
    if (std::filesystem::exists(request.folder) && std::filesystem::equivalent(shard, request.folder)) {
      throw UsageError(shard + ": cannot be both a shard and the folder for the whole");
    }
  }
}

// Joins all rows beside the contents of the folder. Empty if no two shards contradict each other.
std::optional<ExitCode> join(Store& whole, const std::vector<Source>& sources) {
  for (const Source& source : sources) {
    const auto conflicts = merge(whole, source.store);
    if (!conflicts.empty()) return explain_conflicts(source, conflicts);
  }
  whole.close_up();
  return std::nullopt;
}

ExitCode explain_missing(RunFolder& folder, const Completeness& found) {
  const bool replaces = folder.has_earlier_run();
  if (!replaces) folder.install_replacement();
  print_notice(fmt::format("{} of {} realisations are present; `rocking resume {}` runs the rest{}", found.done,
                           found.all, shell_word(folder.name()),
                           replaces ? ". Until then the earlier run is kept" : ""));
  return ExitCode::stopped_early;
}

}  // namespace

ExitCode join_shards(const MergeRequest& request) {
  const std::vector<Source> sources = open_sources(request);
  for (const Source& source : sources) check_same_run(sources.front(), source);
  expect_shards_elsewhere(request);
  RunFolder folder(request.folder);
  folder.claim();
  folder.tidy_up(print_notice);
  expect_room(folder, request);
  const SystemFacts system = system_facts(1);
  Identity identity = sources.front().store.identity();
  identity.shard.reset();
  folder.begin_replacement();
  DiscardUnlessJoined unfinished(folder);
  Store whole = folder.create_store(identity);
  if (const auto failure = join(whole, sources)) return *failure;
  unfinished.keep();
  const Experiment experiment = experiment_of(identity);
  const auto found = completeness(experiment, whole);
  if (found.done < found.all) return explain_missing(folder, found);
  return write_results(
      folder, experiment, complete_result(folder, experiment, whole),
      {.system = system, .loudness = request.loudness, .page = request.page, .extent = request.extent});
}

}  // namespace rocking::program
