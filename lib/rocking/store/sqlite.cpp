#include "rocking/store/sqlite.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>

#include <sqlite3.h>

#include "rocking/base/regular_file.hpp"

namespace rocking::sqlite {
namespace {

int errno_of(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL: return ENOSPC;
    case SQLITE_READONLY: return EROFS;
    case SQLITE_PERM:
    case SQLITE_AUTH: return EACCES;
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return EBUSY;
    case SQLITE_NOMEM: return ENOMEM;
    case SQLITE_CANTOPEN: return ENOENT;
    default: return EIO;
  }
}

// The SQL statements are fixed in this program. If SQLite reports an error in one, the tables are not those of a store.
bool is_fault_of_file(int code) {
  switch (code & 0xff) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:
    case SQLITE_SCHEMA:
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH:
    case SQLITE_FORMAT:
    case SQLITE_TOOBIG: return true;
    default: return false;
  }
}

[[noreturn]] void fail(const std::string& path, int code, const char* message) {
  if (is_fault_of_file(code)) throw UnusableFile(path + ": is damaged: " + message);
  if (code == SQLITE_READONLY_ROLLBACK || code == SQLITE_READONLY_RECOVERY) {
    throw UnusableFile(path + ": a journal is beside it, as after a kill; `rocking resume` includes it");
  }
  throw std::system_error(errno_of(code), std::generic_category(), path + ": " + message);
}

/// SQLite's own mutexes are not needed: see Database.
int flags_of(Access access) {
  switch (access) {
    case Access::read: return SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_READONLY;
    case Access::write: return SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_READWRITE;
    case Access::create: return SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return 0;
}

// SQL that was written into the schema by others, or by a changed bit, must not be executed. Damaged pages must be
// reported, not used.
void distrust(sqlite3* database) {
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_exec(database, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
}

}  // namespace

bool remove_database(const std::filesystem::path& path) {
  const bool was_there = std::filesystem::remove(path);
  remove_logs(path);
  return was_there;
}

void remove_logs(const std::filesystem::path& path) {
  for (const char* suffix : log_suffixes) std::filesystem::remove(path.string() + suffix);
}

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(sqlite3* database, std::string_view sql, std::string path)
    : path_(std::move(path)), database_(database) {
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr));
  statement_.reset(statement);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(path_, sqlite3_extended_errcode(database_), sqlite3_errmsg(database_));
}

void Statement::bind(int place, std::int64_t number) { check(sqlite3_bind_int64(statement_.get(), place + 1, number)); }

void Statement::bind(int place, double number) { check(sqlite3_bind_double(statement_.get(), place + 1, number)); }

void Statement::bind(int place, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), place + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

void Statement::bind(int place, std::span<const std::byte> bytes) {
  check(sqlite3_bind_blob64(statement_.get(), place + 1, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
}

void Statement::bind_null(int place) { check(sqlite3_bind_null(statement_.get(), place + 1)); }

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) check(code);
  return code == SQLITE_ROW;
}

void Statement::run() {
  step();
  reset();
}

void Statement::reset() { check(sqlite3_reset(statement_.get())); }

bool Statement::is_null(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? ""
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::span<const std::byte> Statement::bytes(int column) const {
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

void Database::Closer::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Database::Database(const std::filesystem::path& path, Access access) : path_(path.string()) {
  base::expect_regular_file(path);  // SQLite would wait for ever for the bytes of a pipe
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(path_.c_str(), &database, flags_of(access), nullptr);
  handle_.reset(database);
  if (code != SQLITE_OK) fail(path_, code, database == nullptr ? "not enough memory" : sqlite3_errmsg(database));
  sqlite3_extended_result_codes(database, 1);
  distrust(database);
  sqlite3_busy_timeout(database, 5000);  // ms: a reader waits while the writer moves its log into the database
}

Database Database::of_bytes(std::string_view bytes) {
  Database database = in_memory();
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(std::max<std::size_t>(1, bytes.size())));
  if (copy == nullptr) fail(database.path_, SQLITE_NOMEM, "not enough memory");
  std::copy(bytes.begin(), bytes.end(), copy);
  constexpr unsigned how = SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE;
  const int code = sqlite3_deserialize(database.handle_.get(), "main", copy, size, size, how);
  if (code != SQLITE_OK) fail(database.path_, code, sqlite3_errmsg(database.handle_.get()));
  return database;
}

std::string Database::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> copy(sqlite3_serialize(handle_.get(), "main", &size, 0),
                                                                     &sqlite3_free);
  if (copy == nullptr) fail(path_, SQLITE_NOMEM, "not enough memory");
  std::string bytes(copy.get(), copy.get() + size);
  // A database in memory has no write-ahead log, which these two bytes of a file's header would ask for.
  constexpr std::size_t write_version = 18, read_version = 19;
  if (bytes.size() > read_version) bytes[write_version] = bytes[read_version] = '\1';
  return bytes;
}

bool Database::can_be_opened_again() const {
  int is_elsewhere = 1;  // what a database in memory leaves
  static_cast<void>(sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &is_elsewhere));
  return is_elsewhere == 0;
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(path_, code, sqlite3_errmsg(handle_.get()));
}

std::int64_t number_in(const Database& database, const char* sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

}  // namespace rocking::sqlite
