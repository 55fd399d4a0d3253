#include "rocking/api/run_folder.hpp"

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/text/files.hpp"

namespace rocking {

namespace fs = std::filesystem;

fs::path store_in(const fs::path& folder) { return folder / "realisations.sqlite"; }

bool has_store(const fs::path& folder) {
  std::error_code none;
  const auto bytes = fs::file_size(store_in(folder), none);
  return !none && bytes > 0;
}

namespace {

std::optional<ReportClaims> claims_beside(const fs::path& report) {
  if (!fs::exists(report)) return std::nullopt;
  try {
    return claims_of_report(read_file(report));
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

FolderLock claimed(const fs::path& folder) {
  ensure_writable(folder);
  if (auto lock = FolderLock::of(folder)) return *std::move(lock);
  throw std::system_error(
      std::make_error_code(std::errc::device_or_resource_busy),
      folder.string() + ": another run is at work in this folder; wait for it, or choose another folder");
}

Store valid_store(const fs::path& folder) {
  if (!has_store(folder)) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                            folder.string() + ": contains no run (there is no realisations.sqlite)");
  }
  Store store = Store::open(store_in(folder), sqlite::Access::read);
  if (const auto damage = store.damage()) throw sqlite::UnusableFile(*damage);
  return store;
}

void expect_own_report(const fs::path& folder, const Identity& identity) {
  const fs::path report = folder / "report.json";
  const auto claims = claims_beside(report);
  if (!claims || claims->sha256 == base::to_hex(base::sha256(identity.experiment))) return;
  const std::vector<std::string> differences = experiment_differences(claims->experiment, identity.experiment);
  throw base::InputError({.place = report.string(),
                          .value = "",
                          .reason = "is of another run than " + store_in(folder).string() +
                                    (differences.empty() ? "" : ": in its experiment " + differences.front()),
                          .remedy = "move the one that does not belong there to another folder; `rocking resume " +
                                    folder.string() + "` writes the report of the realisations",
                          .where = {}});
}

base::InputError refused(const fs::path& folder, std::string reason, std::string remedy) {
  return base::InputError(
      {.place = folder.string(), .value = "", .reason = std::move(reason), .remedy = std::move(remedy), .where = {}});
}

}  // namespace rocking
