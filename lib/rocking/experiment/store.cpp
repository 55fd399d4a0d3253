#include "rocking/experiment/store.hpp"

#include <utility>

#include "rocking/experiment/store_row.hpp"
#include "rocking/random/draws.hpp"

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

// The log lets readers look on while a run writes. What a power failure may cost without a flush at each commit is told in
// the header.
void prepare_for_writing(Database& database) {
  database.execute("PRAGMA journal_mode = WAL");
  database.execute("PRAGMA synchronous = NORMAL");
}

std::int64_t number_in(const Database& database, const char* sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
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
  made.execute(
      "CREATE TABLE identity (experiment TEXT NOT NULL, code TEXT NOT NULL, draws TEXT NOT NULL, files TEXT NOT NULL, "
      "part INTEGER, parts INTEGER) STRICT");
  made.execute(table_definition());
  Statement insert = made.prepare("INSERT INTO identity VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(0, identity.experiment);
  insert.bind(1, identity.code);
  insert.bind(2, random::draws_format);
  insert.bind(3, identity.files);
  if (identity.shard) {
    insert.bind(4, static_cast<std::int64_t>(identity.shard->part));
    insert.bind(5, static_cast<std::int64_t>(identity.shard->parts));
  }
  insert.run();
  made.execute("COMMIT");
  store.identity_ = identity;
  return store;
}

Store Store::open(const std::filesystem::path& path, Access access) {
  Store store(Database(path, access));
  store.read_identity();
  if (access == Access::write) prepare_for_writing(store.database_);
  return store;
}

void Store::read_identity() {
  const std::string& path = database_.path();
  if (number_in(database_, "PRAGMA application_id") != application_id) {
    throw sqlite::UnusableFile(path + ": is not a store of realisations");
  }
  Statement layout = database_.prepare("SELECT sql FROM sqlite_master WHERE name = 'realisations'");
  if (!layout.step() || layout.text(0) != table_definition()) {
    throw sqlite::UnusableFile(path +
                               ": was written by another version of the program, in a layout unknown to this one");
  }
  Statement statement = database_.prepare("SELECT experiment, code, draws, files, part, parts FROM identity");
  if (!statement.step()) throw sqlite::UnusableFile(path + ": does not say to what experiment it belongs");
  identity_ = {
      .experiment = statement.text(0), .code = statement.text(1), .files = statement.text(3), .shard = std::nullopt};
  if (statement.text(2) != random::draws_format) {
    throw sqlite::UnusableFile(path + ": its draws are " + statement.text(2) + ", those of this program are " +
                               std::string(random::draws_format));
  }
  if (!statement.is_null(4)) {
    identity_.shard = Shard{.part = static_cast<std::uint64_t>(statement.integer(4)),
                            .parts = static_cast<std::uint64_t>(statement.integer(5))};
  }
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
  database_.execute("PRAGMA journal_mode = DELETE");
}

std::optional<Summary> Store::find(const RealisationKey& key) const {
  Statement statement = database_.prepare("SELECT * FROM realisations WHERE condition = ? AND realisation = ?");
  statement.bind(0, static_cast<std::int64_t>(key.condition));
  statement.bind(1, static_cast<std::int64_t>(key.realisation));
  if (!statement.step()) return std::nullopt;
  return sound_row(statement, database_).summary;
}

void Store::for_each(const std::function<void(const RealisationKey&, const Summary&)>& use) const {
  Statement statement = database_.prepare("SELECT * FROM realisations ORDER BY condition, realisation");
  while (statement.step()) {
    const Row row = sound_row(statement, database_);
    use(row.key, row.summary);
  }
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

}  // namespace rocking::experiment
