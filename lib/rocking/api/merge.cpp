#include <cstddef>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/store/merge.hpp"
#include "rocking/store/results_version.hpp"
#include "rocking/store/store.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;

/// The store of the whole until it is complete; removed with this object unless it was put in its place. The folder is
/// locked.
class UnfinishedWhole {
 public:
  explicit UnfinishedWhole(const fs::path& folder) : folder_(folder), path_(folder / "merging.sqlite") {
    Store::remove(path_);  // of a merge that was killed
  }
  UnfinishedWhole(const UnfinishedWhole&) = delete;
  UnfinishedWhole& operator=(const UnfinishedWhole&) = delete;
  ~UnfinishedWhole() {
    try {
      Store::remove(path_);
    } catch (const fs::filesystem_error&) {
      // The next merge removes it.
    }
  }

  [[nodiscard]] const fs::path& path() const { return path_; }
  /// The store is closed.
  void install() const { fs::rename(path_, RunFiles{folder_}.store()); }

 private:
  fs::path folder_;
  fs::path path_;
};

void check_same_run(const Identity& first, const Identity& other, const fs::path& part) {
  if (other.experiment != first.experiment) {
    throw refused(part, "belongs to another experiment than the first part (a setting or the seed differs)",
                  "merge the parts of one experiment");
  }
  if (other.results != results_version) {
    throw refused(part, "was run by rocking " + other.code + ", which may give other results than this version",
                  "merge it with that version");
  }
}

void join(Store& whole, const Store& part, const fs::path& name) {
  const auto conflicts = merge(whole, part);
  if (conflicts.empty()) return;
  const RealisationKey& key = conflicts.front().key;
  throw refused(name,
                "has " + std::to_string(conflicts.size()) +
                    " realisation(s) that differ from those of an earlier part; "
                    "the first: condition " +
                    std::to_string(key.condition) + ", realisation " + std::to_string(key.realisation),
                "`rocking verify` shows which part is right");
}

}  // namespace

StoredRun merge(const fs::path& folder, const std::vector<fs::path>& parts) {
  if (parts.empty()) refuse("parts", "", "are missing: give at least one folder");
  std::vector<Store> stores;
  for (const fs::path& part : parts) stores.push_back(RunFolder(part).open_valid_store());
  Identity identity = stores.front().identity();
  for (std::size_t i = 0; i < parts.size(); ++i) check_same_run(identity, stores[i].identity(), parts[i]);
  RunFolder run(folder);
  run.claim();
  if (run.has_store()) throw refused(folder, "already contains a run", "choose another folder for the whole");
  run.expect_own_report(identity);
  const UnfinishedWhole unfinished(folder);
  {
    identity.shard.reset();
    Store whole = Store::create(unfinished.path(), identity);
    for (std::size_t i = 0; i < parts.size(); ++i) join(whole, stores[i], parts[i]);
    whole.close_up();
  }
  unfinished.install();
  return open_run(folder);
}

}  // namespace rocking
