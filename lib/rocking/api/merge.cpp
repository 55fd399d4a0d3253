#include <exception>
#include <string>
#include <utility>

#include "rocking/api/folder_run.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/store/difference.hpp"
#include "rocking/store/store_identity.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using base::FolderError;
using Kind = FolderError::Kind;

struct Source {
  std::string name;
  Store store;
};

// The report of the whole names this program, so its rows must have the bits that this program gives.
void check_same_run(const Source& first, const Source& other) {
  const Identity& identity = other.store.identity();
  if (identity.experiment != first.store.identity().experiment) {
    throw FolderError(Kind::in_the_way, other.name,
                      "belongs to another experiment than " + first.name + " (a setting or the seed differs)");
  }
  if (identity.results == results_version) return;
  throw FolderError(Kind::in_the_way, other.name,
                    "was run by rocking " + identity.code + ", and this is " + base::code_identity() +
                        ", which may give other results",
                    "merge with that program");
}

std::vector<Source> sources_of(const std::vector<fs::path>& parts) {
  std::vector<Source> sources;
  for (const fs::path& part : parts) sources.push_back({part.string(), RunFolder(part).open_valid_store()});
  for (const Source& source : sources) check_same_run(sources.front(), source);
  return sources;
}

void expect_parts_elsewhere(const fs::path& folder, const std::vector<fs::path>& parts) {
  for (const fs::path& part : parts) {
    if (!fs::exists(folder) || !fs::equivalent(part, folder)) continue;
    throw FolderError(Kind::contradiction, part.string(), "cannot be both a shard and the folder for the whole");
  }
}

// The whole takes at most as much disk space as its parts.
void expect_room(const RunFolder& folder, const std::vector<fs::path>& parts, bool overwrite) {
  if (!overwrite && (folder.has_store() || folder.has_report() || folder.has_replacement())) {
    throw FolderError(Kind::in_the_way, folder.name(), "already contains a run",
                      "choose another folder for the whole, or add --overwrite");
  }
  std::uintmax_t need = 0;
  for (const fs::path& part : parts) need += fs::file_size(RunFolder(part).store_path());
  folder.expect_room(need);
}

void join(Store& whole, const Source& source) {
  const auto conflicts = merge(whole, source.store);
  if (conflicts.empty()) return;
  const Difference& first = conflicts.front();
  std::string fields;
  for (const std::string& field : first.fields) fields += (fields.empty() ? "" : ", ") + field;
  throw FolderError(Kind::different, source.name,
                    (conflicts.size() == 1 ? "1 realisation is" : counted(conflicts.size(), "realisation") + " are") +
                        " different from an earlier folder; the first: condition " +
                        std::to_string(first.key.condition) + ", realisation " + std::to_string(first.key.realisation) +
                        " (" + fields + "). Nothing was written. `rocking verify` shows which folder is right");
}

// The store has its name when it has all rows: the folder of a merge that was killed has no store.
void join_all(const RunFolder& folder, const std::vector<Source>& sources) {
  const fs::path unfinished = folder.store_path().parent_path() / "merging.sqlite";
  Identity identity = sources.front().store.identity();
  identity.shard.reset();
  {
    Store whole = Store::create(unfinished, identity);
    for (const Source& source : sources) join(whole, source);
    whole.close_up();
  }
  fs::rename(unfinished, folder.store_path());
}

}  // namespace

FolderRun merge_runs(const fs::path& path, const std::vector<fs::path>& parts, bool overwrite, const Tell& tell) {
  const std::vector<Source> sources = sources_of(parts);
  expect_parts_elsewhere(path, parts);
  RunFolder folder(path);
  folder.claim();
  folder.tidy_up(tell);
  expect_room(folder, parts, overwrite);
  folder.begin_replacement();
  try {
    join_all(folder, sources);
  } catch (...) {
    try {
      folder.discard_replacement();
    } catch (const std::exception&) {
      // It stays in its subfolder, where the next run removes it.
    }
    throw;
  }
  Store store = folder.open_store(sqlite::Access::read);
  Experiment experiment = experiment_of(store.identity());
  return {.folder = std::move(folder), .experiment = std::move(experiment), .store = std::move(store)};
}

StoredRun merge(const fs::path& folder, const std::vector<fs::path>& parts) {
  if (parts.empty()) refuse("parts", "", "are missing: give at least one folder");
  with_input_errors([&] { return merge_runs(folder, parts, false); }).folder.install_replacement();
  return open_run(folder);
}

}  // namespace rocking
