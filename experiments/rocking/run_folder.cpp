#include "run_folder.hpp"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/experiment/salvage.hpp"
#include "rocking/report/files.hpp"
#include "rocking/report/read_experiment.hpp"

namespace rocking::program {
namespace {

void remove_database(const std::filesystem::path& path) {
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path.string() + suffix);
}

std::filesystem::path first_free_name(const std::filesystem::path& folder) {
  for (int number = 1;; ++number) {
    std::filesystem::path name = folder / fmt::format("damaged-{}.sqlite", number);
    if (!std::filesystem::exists(name)) return name;
  }
}

/// SQLite opens no file whose absolute path, with the ending of its log, has more than 512 bytes.
void expect_short_path(const std::filesystem::path& store) {
  constexpr std::size_t longest = 512;
  constexpr std::string_view longest_ending = ".new-journal";
  const std::size_t length = std::filesystem::absolute(store).string().size() + longest_ending.size();
  if (length <= longest) return;
  throw UsageError(fmt::format("the path of the folder is {} bytes too long for SQLite ({} at most); choose a shorter one: {}",
                               length - longest, longest, base::cut_to(store.parent_path().string(), 100)));
}

// Whether the open file is still the one of this name.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

}  // namespace

RunFolder::~RunFolder() {
  if (lock_ < 0) return;
  ::unlink(lock_path().c_str());
  ::close(lock_);
}

// A file of its own, open for writing: some network file systems lock nothing else. Who held the lock before may have removed
// the file since it was opened here; a lock on it then guards nothing, and another try finds a new one.
void RunFolder::claim() {
  expect_short_path(store_path());
  report::ensure_writable(path_);
  while (lock_ < 0) {
    lock_ = ::open(lock_path().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0) throw std::system_error(errno, std::generic_category(), lock_path().string() + ": cannot be opened");
    wait_for_lock();
    if (is_file_at(lock_, lock_path())) return;
    ::close(std::exchange(lock_, -1));
  }
}

void RunFolder::wait_for_lock() {
  for (int attempt = 0; ::flock(lock_, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK) return;  // a file system that knows no locks cannot tell; there the user has to
    if (attempt == 10) {
      ::close(std::exchange(lock_, -1));
      throw InTheWay(name() + ": another `rocking` is at work in this folder; wait for it, or choose another folder");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // `rocking status` holds it for a moment
  }
}

bool RunFolder::is_at_work() const {
  const int lock = ::open(lock_path().c_str(), O_RDONLY | O_CLOEXEC);
  if (lock < 0) return false;
  const bool held = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(lock);
  return held;
}

void RunFolder::expect_room(std::uint64_t bytes) const {
  std::error_code unknown;
  const std::uintmax_t free = std::filesystem::space(path_, unknown).available;
  if (unknown || bytes <= free) return;
  throw std::system_error(
      std::make_error_code(std::errc::no_space_on_device),
      fmt::format("{}: its realisations may need {}, {} are free; make room, choose another disk, or "
                  "divide the run with --shard",
                  name(), spoken_size(bytes), spoken_size(free)));
}

experiment::Store RunFolder::create_store(const experiment::Identity& identity) const {
  return experiment::Store::create(store_path(), identity);
}

experiment::Store RunFolder::open_store(experiment::sqlite::Access access) const {
  expect_short_path(store_path());
  if (!has_store()) throw MissingInput(name() + ": holds no run (there is no realisations.sqlite)");
  return experiment::Store::open(store_path(), access);
}

RunFolder::Mending RunFolder::mend_store(experiment::Store damaged, const experiment::Experiment& experiment) const {
  const std::filesystem::path mended = path_ / "mended.sqlite";
  remove_database(mended);
  Mending mending;
  {
    experiment::Store store = experiment::Store::create(mended, damaged.identity());
    mending.kept = experiment::salvage(experiment, damaged, store);
    store.close_up();
  }
  { const experiment::Store closed = std::move(damaged); }
  mending.damaged_file = first_free_name(path_);
  std::error_code no_links;
  std::filesystem::create_hard_link(store_path(), mending.damaged_file, no_links);
  if (no_links) std::filesystem::copy_file(store_path(), mending.damaged_file);
  // A log of the damaged file would be taken for the new one's.
  for (const char* suffix : {"-wal", "-shm", "-journal"}) {
    const std::filesystem::path log = store_path().string() + suffix;
    if (std::filesystem::exists(log)) std::filesystem::rename(log, mending.damaged_file.string() + suffix);
  }
  std::filesystem::rename(mended, store_path());
  return mending;
}

void RunFolder::clear() const {
  for (const auto& path : {report_path(), page_path(), progress_path()}) std::filesystem::remove(path);
  remove_database(store_path());
}

std::string code_identity() {
  const base::BuildInfo build = base::build_info();
  return fmt::format("{} {}", build.version, build.revision);
}

experiment::Experiment experiment_of(const experiment::Identity& identity) {
  try {
    return report::read_experiment(identity.experiment, {}, {.files = report::files_seen_from(identity.files)});
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

}  // namespace rocking::program
