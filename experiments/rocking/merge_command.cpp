#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "rocking/experiment/merge.hpp"
#include "rocking/experiment/run.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct MergeRequest {
  std::string folder;
  std::vector<std::string> shards;
  Loudness loudness;
  bool overwrite = false;
};

struct Source {
  std::string name;
  experiment::Store store;
};

std::vector<Source> open_sources(const MergeRequest& request) {
  std::vector<Source> sources;
  for (const std::string& name : request.shards) {
    sources.push_back({name, RunFolder(name).open_sound_store()});
  }
  return sources;
}

// The rows of two programs belong together where both are known to give the same bits.
bool give_the_same_bits(const experiment::Identity& one, const experiment::Identity& other) {
  return one.code == other.code || (one.results == other.results && one.results != 0);
}

// One question, one results version: else the rows do not belong together.
void expect_kin(const Source& first, const Source& other) {
  if (other.store.identity().experiment != first.store.identity().experiment) {
    throw InTheWay(fmt::format("{}: belongs to another experiment than {} (a setting or the seed differs)", other.name,
                               first.name));
  }
  if (!give_the_same_bits(first.store.identity(), other.store.identity())) {
    throw InTheWay(fmt::format("{}: was run by rocking {}, but {} by {}", other.name, other.store.identity().code,
                               first.name, first.store.identity().code));
  }
}

ExitCode explain_conflicts(const Source& source, const std::vector<experiment::Difference>& conflicts) {
  const experiment::Difference& first = conflicts.front();
  print_notice(fmt::format(
      "{}: {} not what an earlier folder says; the first: condition {}, realisation {} ({}). Nothing was "
      "written. `rocking verify` tells which folder is right",
      source.name, conflicts.size() == 1 ? "1 realisation is" : counted(conflicts.size(), "realisation") + " are",
      first.key.condition, first.key.realisation, fmt::join(first.fields, ", ")));
  return ExitCode::check_failed;
}

// The whole takes at most as much room as its parts.
void make_room(const RunFolder& folder, const MergeRequest& request) {
  if (request.overwrite) folder.clear();
  if (folder.has_store() || folder.has_report()) {
    throw InTheWay(request.folder + ": holds a run already; choose another folder for the whole, or add --overwrite");
  }
  std::uintmax_t need = 0;
  for (const std::string& shard : request.shards) need += std::filesystem::file_size(RunFolder(shard).store_path());
  folder.expect_room(need);
}

void expect_shards_elsewhere(const MergeRequest& request) {
  for (const std::string& shard : request.shards) {
    if (std::filesystem::exists(request.folder) && std::filesystem::equivalent(shard, request.folder)) {
      throw UsageError(shard + ": cannot be a shard and the folder for the whole at once");
    }
  }
}

ExitCode merge(const MergeRequest& request) {
  const std::vector<Source> sources = open_sources(request);
  for (const Source& source : sources) expect_kin(sources.front(), source);
  expect_shards_elsewhere(request);
  RunFolder folder(request.folder);
  folder.claim();
  make_room(folder, request);
  const report::SystemFacts system = system_facts(1);
  experiment::Identity identity = sources.front().store.identity();
  identity.shard.reset();
  experiment::Store whole = folder.create_store(identity);
  for (const Source& source : sources) {
    const auto conflicts = experiment::merge(whole, source.store);
    if (!conflicts.empty()) {
      folder.clear();
      return explain_conflicts(source, conflicts);
    }
  }
  whole.close_up();
  const experiment::Experiment experiment = experiment_of(identity);
  const auto [done, all] = experiment::completeness(experiment, whole);
  if (done < all) {
    print_notice(
        fmt::format("{} of {} realisations are there; `rocking resume {}` runs the rest", done, all, request.folder));
    return ExitCode::stopped_early;
  }
  return conclude(folder, experiment, complete_result(folder, experiment, whole),
                  {.system = system, .loudness = request.loudness});
}

}  // namespace

void add_merge(CLI::App& app, Action& action) {
  const auto request = std::make_shared<MergeRequest>();
  CLI::App* command = app.add_subcommand("merge", "Join the shards of a run");
  command->footer(
      "Example: rocking merge out shard1 shard2 shard3\n"
      "puts the realisations of the three folders together in out and writes the report, with the bytes of one run. "
      "The\n"
      "order does not matter; shards may overlap where they agree.");
  command->add_option("DIR", request->folder, "Folder for the whole; made if need be")->required();
  command->add_option("SHARD", request->shards, "Folders of the parts")->required();
  command->add_flag("--overwrite", request->overwrite, "Replace what an earlier merge left in the folder");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return merge(*request); }; });
}

}  // namespace rocking::program
