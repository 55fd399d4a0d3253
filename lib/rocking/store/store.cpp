#include "rocking/store/store.hpp"

#include <chrono>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "rocking/base/error.hpp"
#include "rocking/store/store_identity.hpp"

namespace rocking {
namespace {

using sqlite::Access;
using sqlite::Database;
using sqlite::Statement;

std::string text_in(const Database& database, const char* sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.text(0) : "";
}

// Changes the journal mode and returns the mode in force afterwards. While others read, SQLite refuses the change at
// once, whatever the timeout; therefore it is retried until they have finished.
std::string changed_journal_mode(const Database& database, const std::string& mode) {
  constexpr std::chrono::milliseconds pause(5);
  constexpr int most_tries = 2000;
  for (int tries = 1;; ++tries) {
    try {
      return text_in(database, ("PRAGMA journal_mode = " + mode).c_str());
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::device_or_resource_busy || tries == most_tries) throw;
    }
    std::this_thread::sleep_for(pause);
  }
}

// With a write-ahead log others can read while a run writes. What a power failure can cost without a flush at each
// commit is described in the header. Returns false if the file system has no shared memory, which the log needs.
bool begin_write_ahead(Database& database) {
  if (changed_journal_mode(database, "WAL") != "wal") return false;
  database.execute(
      "PRAGMA synchronous = NORMAL; BEGIN IMMEDIATE; ROLLBACK");  // the shared memory is not requested before
  return true;
}

// Releases the lock that exclusive ones have kept.
void use_normal_locks(Database& database) {
  database.execute("PRAGMA locking_mode = NORMAL");
  sqlite::number_in(database, "SELECT count(*) FROM sqlite_master");
}

// Exclusive locks replace the shared memory while the remaining log is moved into the database.
void begin_rollback(Database& database) {
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  database.execute("PRAGMA journal_mode = TRUNCATE");
  use_normal_locks(database);
  database.execute("PRAGMA synchronous = FULL");
}

// A new name is on the disk only after its folder is flushed.
void flush_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// A checksum proves that a row was written so, not that it is in its place: pages may have been exchanged.
void expect_in_place(bool is_in_place, const RealisationKey& key, const Database& database) {
  if (is_in_place) return;
  throw sqlite::UnusableFile(database.path() + ": is damaged: the row of " + text_of(key) + " is not in its place");
}

// The store is created under another name and renamed. A process killed on the way leaves no store instead of an
// incomplete one.
std::filesystem::path unfinished_name(std::filesystem::path path) { return path += ".new"; }

}  // namespace

bool Store::remove(const std::filesystem::path& path) {
  const bool was_there = sqlite::remove_database(path);
  return remove_unfinished(path) || was_there;
}

bool Store::remove_unfinished(const std::filesystem::path& path) {
  return sqlite::remove_database(unfinished_name(path));
}

Store Store::create(const std::filesystem::path& path, const Identity& identity) {
  const std::filesystem::path unfinished = unfinished_name(path);
  sqlite::remove_database(unfinished);
  { const std::ofstream empty(unfinished); }  // with the permissions of the umask; those that SQLite sets are narrower
  {
    // Nobody continues an unfinished store, so that it needs no journal on disk; each change is flushed. It gets the
    // mode in which it is opened below, because a change of mode afterwards would need a journal and four more flushes.
    Database database(unfinished, Access::create);
    database.execute("PRAGMA journal_mode = MEMORY");
    Store store = made(std::move(database), identity);
    store.database_.execute("PRAGMA journal_mode = WAL");
  }
  sqlite::remove_logs(path);
  std::filesystem::rename(unfinished, path);
  flush_folder_of(path);
  return open(path, Access::write);
}

Store Store::in_memory(const Identity& identity) { return made(Database::in_memory(), identity); }

Store Store::made(Database database, const Identity& identity) {
  Store store(std::move(database));
  Database& made = store.database_;
  made.execute("BEGIN IMMEDIATE");
  lay_out(made);
  write_identity(made, identity);
  made.execute("COMMIT");
  store.identity_ = identity;
  store.rows_ = RowFormat(identity.experiment);
  return store;
}

Store Store::open(const std::filesystem::path& path, Access access) {
  if (access == Access::read) return read(Database(path, access));
  try {
    Store store = read(Database(path, access));
    if (begin_write_ahead(store.database_)) return store;
  } catch (const std::system_error&) {
    // The shared memory may be missing. Any other cause is reported by the next attempt.
  }
  Database database(path, access);
  begin_rollback(database);
  Store store = read(std::move(database));
  store.journalling_ = Journalling::rollback;
  return store;
}

Store Store::read(Database database) {
  Store store(std::move(database));
  expect_current_layout(store.database_);
  store.identity_ = read_identity(store.database_);
  store.rows_ = RowFormat(store.identity_.experiment);
  return store;
}

void Store::add(const RealisationKey& key, const Summary& summary) {
  if (!in_transaction_) {
    database_.execute("BEGIN IMMEDIATE");
    in_transaction_ = true;
  }
  if (!insert_) {
    insert_ = database_.prepare("INSERT OR REPLACE INTO realisations (" + row_columns() + ") VALUES (" +
                                row_placeholders() + ")");
  }
  rows_.bind(*insert_, key, summary);
  insert_->run();
}

void Store::commit() {
  if (!in_transaction_) return;
  database_.execute("COMMIT");
  in_transaction_ = false;
}

void Store::close_up() {
  commit();
  // With exclusive locks from here on: otherwise SQLite removes the log before it writes that there is none, and whoever reads
  // in between makes it anew, empty, and leaves it.
  database_.execute("PRAGMA locking_mode = EXCLUSIVE");
  static_cast<void>(changed_journal_mode(database_, "DELETE"));
  use_normal_locks(database_);
}

Row Store::sound_row(const Statement& statement) const {
  if (auto row = rows_.read(statement)) return std::move(*row);
  const RealisationKey key{static_cast<std::uint64_t>(statement.integer(0)),
                           static_cast<std::uint64_t>(statement.integer(1))};
  throw sqlite::UnusableFile(database_.path() + ": the row of " + text_of(key) + " differs from what was written");
}

std::optional<Summary> Store::find(const RealisationKey& key) const {
  auto statement = std::exchange(find_, std::nullopt);  // a statement that fails is not used again
  if (!statement) {
    statement =
        database_.prepare("SELECT " + row_columns() + " FROM realisations WHERE condition = ? AND realisation = ?");
  }
  statement->bind(0, static_cast<std::int64_t>(key.condition));
  statement->bind(1, static_cast<std::int64_t>(key.realisation));
  std::optional<Row> found;
  if (statement->step()) found = sound_row(*statement);
  if (found && found->key != key) {
    throw sqlite::UnusableFile(database_.path() + ": is damaged: in place of " + text_of(key) + " it has the row of " +
                               text_of(found->key));
  }
  statement->reset();
  find_ = std::move(statement);
  return found ? std::optional(std::move(found->summary)) : std::nullopt;
}

void Store::walk(const Database& database, std::int64_t first, std::int64_t last, const UseOfRow& use) const {
  Statement statement = database.prepare(
      "SELECT " + row_columns() + " FROM realisations WHERE condition BETWEEN ? AND ? ORDER BY condition, realisation");
  statement.bind(0, first);
  statement.bind(1, last);
  std::optional<RealisationKey> before;
  while (statement.step()) {
    const Row row = sound_row(statement);
    const auto condition = static_cast<std::int64_t>(row.key.condition);
    const bool is_in_range = first <= condition && condition <= last;
    expect_in_place(is_in_range && (!before || *before < row.key), row.key, database_);
    before = row.key;
    use(row.key, row.summary);
  }
}

void Store::for_each(const UseOfRow& use) const {
  using Number = std::numeric_limits<std::int64_t>;
  walk(database_, Number::min(), Number::max(), use);
}

void Store::for_each_side_by_side(const base::ManyParts& how, const UseOfRow& use) const {
  constexpr std::int64_t parts_of_a_thread = 8;
  const std::int64_t last = number_in(database_, "SELECT max(condition) FROM realisations");
  if (how.threads < 2 || last < 1 || in_transaction_ || !database_.can_be_opened_again()) return for_each(use);
  const std::int64_t conditions = last / (parts_of_a_thread * how.threads) + 1;  // of a part
  base::for_each_part(how, static_cast<std::size_t>(last / conditions + 1), [&](std::size_t part) {
    const std::int64_t first = static_cast<std::int64_t>(part) * conditions;
    walk(Database(database_.path(), Access::read), first, first + conditions - 1, use);
  });
}

std::optional<std::string> Store::damage() const {
  try {
    const std::string finding = text_in(database_, "PRAGMA integrity_check(1)");
    if (finding != "ok") return database_.path() + ": is damaged: " + finding;
    for_each([](const RealisationKey&, const Summary&) {});
  } catch (const sqlite::UnusableFile& error) {
    return error.what();
  }
  return std::nullopt;
}

void Store::for_each_key(const std::function<void(const RealisationKey&)>& use) const {
  Statement statement =
      database_.prepare("SELECT condition, realisation FROM realisations ORDER BY condition, realisation");
  std::optional<RealisationKey> last;
  while (statement.step()) {
    const RealisationKey key{static_cast<std::uint64_t>(statement.integer(0)),
                             static_cast<std::uint64_t>(statement.integer(1))};
    expect_in_place(!last || *last < key, key, database_);
    last = key;
    use(key);
  }
}

std::map<section::ResponseMode, std::uint64_t> Store::mode_counts(std::uint64_t condition,
                                                                  std::uint64_t realisations) const {
  std::map<section::ResponseMode, std::uint64_t> counts;
  const auto number = static_cast<std::int64_t>(condition);
  walk(database_, number, number, [&](const RealisationKey& key, const Summary& summary) {
    if (key.realisation < realisations) ++counts[summary.mode];
  });
  return counts;
}

}  // namespace rocking
