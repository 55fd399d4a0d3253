#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// A thin owner of SQLite's handles. Every call that fails throws: UnusableFile where the file is no sound database,
/// std::system_error with the path for everything else (a full disk, no permission).
namespace rocking::experiment::sqlite {

/// A file that is damaged, or not what it should be.
class UnusableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One prepared statement. Parameters and columns count from 0.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql, std::string path);

  void bind(int place, std::int64_t number);
  void bind(int place, double number);
  void bind(int place, std::string_view text);
  void bind(int place, std::span<const std::byte> bytes);
  void bind_null(int place);

  /// Goes to the next row; false after the last.
  bool step();
  /// Runs a statement that returns no rows, and makes it ready to run again.
  void run();
  /// Ready to run again with new parameters.
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

/// What SQLite may leave beside a database: the name of its file and one of these.
inline constexpr std::array<const char*, 3> log_suffixes{"-wal", "-shm", "-journal"};

/// Removes what lies beside a database. SQLite takes a log for that of any database of its name.
void remove_logs(const std::filesystem::path& path);
/// Removes a database and what lies beside it.
void remove_database(const std::filesystem::path& path);

/// A database, to be used by one thread at a time. Triggers and views in it are not carried out.
class Database {
 public:
  Database(const std::filesystem::path& path, Access access);
  /// A database that lives in memory and with this object.
  [[nodiscard]] static Database in_memory() { return Database(":memory:", Access::create); }

  void execute(const std::string& sql);
  [[nodiscard]] Statement prepare(std::string_view sql) const { return {handle_.get(), sql, path_}; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };

  std::string path_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

}  // namespace rocking::experiment::sqlite
