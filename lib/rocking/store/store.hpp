#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/base/many_parts.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/store/store_identity.hpp"
#include "rocking/store/store_row.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// How a store that is being written is protected against a kill.
enum class Journalling : std::uint8_t {
  write_ahead,  ///< a log beside the file; others can read at any time
  rollback,     ///< for file systems without shared memory: a commit saves the old pages first
};

/// The store of a run: a SQLite database with one row per finished realisation, written while the run continues.
///
/// Its table `realisations` has the key (condition, realisation) and a column for each field of a Summary. Rows become
/// durable in groups. A killed process loses the rows added since the last commit; a power failure may lose the last
/// commits. Nothing else is lost. There can be one writer at a time.
///
/// Throws as described in sqlite.hpp. sqlite::UnusableFile is also thrown if a file is not a store, if a row is not
/// what was written, or if a row is not in the place of its key.
class Store {
 public:
  /// Creates a store; the file must not exist.
  [[nodiscard]] static Store create(const std::filesystem::path& path, const Identity& identity);
  /// Removes a store that is not open, with what remains of a create() that was killed. Returns whether there was any.
  static bool remove(const std::filesystem::path& path);
  /// Removes what remains of a create() that was killed. Returns whether there was any.
  static bool remove_unfinished(const std::filesystem::path& path);
  /// Opens an existing store.
  [[nodiscard]] static Store open(const std::filesystem::path& path, sqlite::Access access);
  /// A store in memory with the lifetime of this object.
  [[nodiscard]] static Store in_memory(const Identity& identity);
  /// A store in memory with the contents of bytes().
  [[nodiscard]] static Store of_bytes(std::string_view bytes) { return read(sqlite::Database::of_bytes(bytes)); }
  /// All of it, as the bytes of a file.
  [[nodiscard]] std::string bytes() const { return database_.bytes(); }

  [[nodiscard]] const Identity& identity() const { return identity_; }
  /// The protection in use, for a store opened for writing.
  [[nodiscard]] Journalling journalling() const { return journalling_; }

  /// Adds a row or replaces the one with this key.
  void add(const RealisationKey& key, const Summary& summary);
  /// Makes the added rows durable.
  void commit();
  /// As commit; leaves a single file, which can be read on a read-only file system. Rows can still be added afterwards.
  void close_up();

  [[nodiscard]] std::optional<Summary> find(const RealisationKey& key) const;
  using UseOfRow = std::function<void(const RealisationKey&, const Summary&)>;
  /// Calls `use` for every row, in the order of the keys.
  void for_each(const UseOfRow& use) const;
  /// Calls `use` for every durable row, by several threads: those of a condition in their order, by one of them. A part is a
  /// group of conditions. Rows behind a damaged page may be left out.
  void for_each_side_by_side(const base::ManyParts& how, const UseOfRow& use) const;
  /// Description of the first damage found in the file; absent if every page and every row is as written. Reads the
  /// whole file.
  [[nodiscard]] std::optional<std::string> damage() const;
  void for_each_key(const std::function<void(const RealisationKey&)>& use) const;
  /// Number of realisations below `realisations`, by response mode.
  [[nodiscard]] std::map<section::ResponseMode, std::uint64_t> mode_counts(std::uint64_t condition,
                                                                           std::uint64_t realisations) const;

 private:
  explicit Store(sqlite::Database database) : database_(std::move(database)) {}
  [[nodiscard]] static Store made(sqlite::Database database, const Identity& identity);
  [[nodiscard]] static Store read(sqlite::Database database);
  [[nodiscard]] Row sound_row(const sqlite::Statement& statement) const;
  void walk(const sqlite::Database& database, std::int64_t first, std::int64_t last, const UseOfRow& use) const;

  sqlite::Database database_;
  Identity identity_;
  RowFormat rows_{std::string()};
  Journalling journalling_ = Journalling::write_ahead;
  std::optional<sqlite::Statement> insert_;
  mutable std::optional<sqlite::Statement> find_;
  bool in_transaction_ = false;
};

}  // namespace rocking
