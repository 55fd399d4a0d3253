#include "rocking/experiment/store.hpp"

#include <chrono>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "rocking/experiment/store_row.hpp"

namespace rocking::experiment {
namespace {

using sqlite::Access;
using sqlite::Database;
using sqlite::Statement;

constexpr std::int64_t application_id = 0x726f636b;  // "rock": by which `file` and others know such a database

std::string table_definition() {
  return "CREATE TABLE realisations (" + column_definitions() +
         ", PRIMARY KEY (condition, realisation)) STRICT, WITHOUT ROWID";
}

std::int64_t number_in(const Database& database, const char* sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

std::string text_in(const Database& database, const char* sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.text(0) : "";
}

// While others look on, SQLite refuses to change the journal's mode at once, whatever the timeout: tried until they have looked.
// Returns the mode that it has then.
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

// The log lets readers look on while a run writes. What a power failure may cost without a flush at each commit is told in
// the header. False where the file system has no shared memory, which the log needs.
bool begin_write_ahead(Database& database) {
  if (changed_journal_mode(database, "WAL") != "wal") return false;
  database.execute("PRAGMA synchronous = NORMAL; BEGIN IMMEDIATE; ROLLBACK");  // the memory is not asked for before
  return true;
}

// Exclusive locks stand in for the shared memory while what a log may still hold is folded in.
void begin_rollback(Database& database) {
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  database.execute("PRAGMA journal_mode = TRUNCATE");
  database.execute("PRAGMA locking_mode = NORMAL");
  database.execute("PRAGMA synchronous = FULL");
  number_in(database, "SELECT count(*) FROM sqlite_master");  // lets go of the lock
}

void expect_layout(const Database& database) {
  if (number_in(database, "PRAGMA application_id") != application_id) {
    throw sqlite::UnusableFile(database.path() + ": is not a store of realisations");
  }
  const bool known =
      text_in(database, "SELECT sql FROM sqlite_master WHERE name = 'realisations'") == table_definition() &&
      text_in(database, "SELECT sql FROM sqlite_master WHERE name = 'identity'") == identity_table();
  if (known) return;
  throw sqlite::UnusableFile(database.path() +
                             ": is damaged, or was written by another version of the program in a layout unknown to "
                             "this one");
}

Row sound_row(const Statement& statement, const Database& database) {
  if (auto row = read_row(statement)) return std::move(*row);
  throw sqlite::UnusableFile(database.path() + ": the row of condition " + std::to_string(statement.integer(0)) +
                             ", realisation " + std::to_string(statement.integer(1)) + " is not what was written");
}

}  // namespace

Store Store::create(const std::filesystem::path& path, const Identity& identity) {
  // Made beside its place and moved there whole: whoever is killed here leaves no store, rather than one that is none.
  std::filesystem::path unfinished = path;
  unfinished += ".new";
  for (const char* suffix : {"", "-journal"}) std::filesystem::remove(unfinished.string() + suffix);
  { static_cast<void>(made(Database(unfinished, Access::create), identity)); }
  std::filesystem::rename(unfinished, path);
  return open(path, Access::write);
}

Store Store::in_memory(const Identity& identity) { return made(Database::in_memory(), identity); }

Store Store::made(Database database, const Identity& identity) {
  Store store(std::move(database));
  Database& made = store.database_;
  made.execute("BEGIN IMMEDIATE");
  made.execute("PRAGMA application_id = " + std::to_string(application_id));
  made.execute(identity_table());
  made.execute(table_definition());
  write_identity(made, identity);
  made.execute("COMMIT");
  store.identity_ = identity;
  return store;
}

Store Store::open(const std::filesystem::path& path, Access access) {
  if (access == Access::read) return read(Database(path, access));
  try {
    Store store = read(Database(path, access));
    if (begin_write_ahead(store.database_)) return store;
  } catch (const std::system_error&) {
    // Perhaps the shared memory is missing. What else it may be shows at the next try.
  }
  Database database(path, access);
  begin_rollback(database);
  Store store = read(std::move(database));
  store.journalling_ = Journalling::rollback;
  return store;
}

Store Store::read(Database database) {
  Store store(std::move(database));
  expect_layout(store.database_);
  store.identity_ = read_identity(store.database_);
  return store;
}

void Store::add(const RealisationKey& key, const Summary& summary) {
  if (!in_transaction_) {
    database_.execute("BEGIN IMMEDIATE");
    in_transaction_ = true;
  }
  if (!insert_) insert_ = database_.prepare("INSERT OR REPLACE INTO realisations VALUES " + column_placeholders());
  bind_row(*insert_, key, summary);
  insert_->run();
}

void Store::commit() {
  if (!in_transaction_) return;
  database_.execute("COMMIT");
  in_transaction_ = false;
}

void Store::close_up() {
  commit();
  static_cast<void>(changed_journal_mode(database_, "DELETE"));
}

std::optional<Summary> Store::find(const RealisationKey& key) const {
  auto statement = std::exchange(find_, std::nullopt);  // one that fails is not used again
  if (!statement) statement = database_.prepare("SELECT * FROM realisations WHERE condition = ? AND realisation = ?");
  statement->bind(0, static_cast<std::int64_t>(key.condition));
  statement->bind(1, static_cast<std::int64_t>(key.realisation));
  std::optional<Summary> found;
  if (statement->step()) found = sound_row(*statement, database_).summary;
  statement->reset();
  find_ = std::move(statement);
  return found;
}

void Store::for_each(const std::function<void(const RealisationKey&, const Summary&)>& use) const {
  Statement statement = database_.prepare("SELECT * FROM realisations ORDER BY condition, realisation");
  while (statement.step()) {
    const Row row = sound_row(statement, database_);
    use(row.key, row.summary);
  }
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
  while (statement.step()) {
    use({.condition = static_cast<std::uint64_t>(statement.integer(0)),
         .realisation = static_cast<std::uint64_t>(statement.integer(1))});
  }
}

std::map<section::ResponseMode, std::uint64_t> Store::mode_counts(std::uint64_t condition,
                                                                  std::uint64_t realisations) const {
  Statement statement = database_.prepare(
      "SELECT mode, count(*) FROM realisations WHERE condition = ? AND realisation < ? GROUP BY mode");
  statement.bind(0, static_cast<std::int64_t>(condition));
  statement.bind(1, static_cast<std::int64_t>(realisations));
  std::map<section::ResponseMode, std::uint64_t> counts;
  while (statement.step()) {
    const auto mode = section::response_mode_named(statement.text(0));
    if (!mode) throw sqlite::UnusableFile(database_.path() + ": \"" + statement.text(0) + "\" is no response mode");
    counts[*mode] += static_cast<std::uint64_t>(statement.integer(1));
  }
  return counts;
}

std::map<dynamics::Termination, std::uint64_t> Store::termination_counts() const {
  Statement statement = database_.prepare("SELECT termination, count(*) FROM realisations GROUP BY termination");
  std::map<dynamics::Termination, std::uint64_t> counts;
  while (statement.step()) {
    if (const auto termination = dynamics::termination_named(statement.text(0))) {
      counts[*termination] += static_cast<std::uint64_t>(statement.integer(1));
    }
  }
  return counts;
}

}  // namespace rocking::experiment
