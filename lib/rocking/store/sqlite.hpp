#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "rocking/base/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

/// Owners of SQLite's handles. A call that fails throws UnusableFile if the file is not a sound database, and
/// std::system_error with the path otherwise (for example disk full, no permission).
namespace rocking::sqlite {

using base::UnusableFile;

/// One prepared statement. Parameters and columns count from 0.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql, std::string path);

  void bind(int place, std::int64_t number);
  void bind(int place, double number);
  void bind(int place, std::string_view text);
  void bind(int place, std::span<const std::byte> bytes);
  void bind_null(int place);

  /// Advances to the next row; false after the last.
  bool step();
  /// Executes a statement that returns no rows, and resets it.
  void run();
  /// Resets the statement, so that it can be executed again with new parameters.
  void reset();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::span<const std::byte> bytes(int column) const;  ///< valid until the next step

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int code) const;

  std::string path_;
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
};

enum class Access : std::uint8_t { read, write, create };

/// Suffixes of the files that SQLite may leave beside a database.
inline constexpr std::array<const char*, 3> log_suffixes{"-wal", "-shm", "-journal"};

/// Removes these files. SQLite would use a log with that name for any database of the name.
void remove_logs(const std::filesystem::path& path);
/// Removes a database and these files. Returns whether there was a database.
bool remove_database(const std::filesystem::path& path);

/// A database, to be used by one thread at a time. Its triggers and views are not executed.
class Database {
 public:
  Database(const std::filesystem::path& path, Access access);
  /// A database in memory with the lifetime of this object.
  [[nodiscard]] static Database in_memory() { return Database(":memory:", Access::create); }
  /// A database in memory with the contents of bytes().
  [[nodiscard]] static Database of_bytes(std::string_view bytes);
  /// All of it, as the bytes of a file.
  [[nodiscard]] std::string bytes() const;

  void execute(const std::string& sql);
  [[nodiscard]] Statement prepare(std::string_view sql) const { return {handle_.get(), sql, path_}; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Whether its path leads to this database: not where it is in memory, or was moved or removed.
  [[nodiscard]] bool can_be_opened_again() const;

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };

  std::string path_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

/// The number in the first column of the first row of the result of `sql`; 0 if there is no row.
std::int64_t number_in(const Database& database, const char* sql);

}  // namespace rocking::sqlite
