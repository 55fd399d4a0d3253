#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "rocking/experiment/sqlite.hpp"
#include "rocking/experiment/store_identity.hpp"
#include "rocking/experiment/store_layout.hpp"
#include "rocking/experiment/store_row.hpp"
#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// How a store that is being written guards itself against a kill.
enum class Journalling : std::uint8_t {
  write_ahead,  ///< a log beside the file; others can read at any time
  rollback,     ///< what a file system without shared memory allows: old pages are kept aside during each commit
};

/// The journal of a run: a SQLite database with a row for each finished realisation, written while the run goes on.
///
/// Its table `realisations` has the key (condition, realisation) and a column for each field of a Summary. Rows become
/// durable in groups: a killed process loses what it added since the last commit, a machine without power may lose the
/// last commits, and neither loses anything else. One writer at a time.
/// Throws as sqlite.hpp says; sqlite::UnusableFile also where a file is no store, a row is not what was written, or a row is
/// not in the place of its key.
class Store {
 public:
  /// A new one, where no file is yet.
  [[nodiscard]] static Store create(const std::filesystem::path& path, const Identity& identity);
  /// One that is there.
  [[nodiscard]] static Store open(const std::filesystem::path& path, sqlite::Access access);
  /// One that lives and dies with this object.
  [[nodiscard]] static Store in_memory(const Identity& identity);

  [[nodiscard]] const Identity& identity() const { return identity_; }
  /// Whether rows can be added: those of an earlier layout are only read, `salvage` takes them over into a new store.
  [[nodiscard]] bool is_of_current_layout() const { return layout_ == current_layout; }
  /// Of a store opened for writing.
  [[nodiscard]] Journalling journalling() const { return journalling_; }

  /// Adds a row, or replaces the one of this key. Asks for the current layout.
  void add(const RealisationKey& key, const Summary& summary);
  /// Makes durable what was added.
  void commit();
  /// The same, and leaves a single file behind, which can be read where nothing can be written. Adding goes on afterwards.
  void close_up();

  [[nodiscard]] std::optional<Summary> find(const RealisationKey& key) const;
  /// Whether this program gives the same bits for a row of this store: see results_version.hpp.
  [[nodiscard]] bool has_current_bits(const RealisationKey& key, const Summary& row) const;
  /// Every row, in the order of the keys.
  void for_each(const std::function<void(const RealisationKey&, const Summary&)>& use) const;
  /// What is wrong in the file, the first thing found; absent where every page and every row is as it was written. Reads all.
  [[nodiscard]] std::optional<std::string> damage() const;
  void for_each_key(const std::function<void(const RealisationKey&)>& use) const;
  /// Realisations numbered below `realisations`, by response mode.
  [[nodiscard]] std::map<section::ResponseMode, std::uint64_t> mode_counts(std::uint64_t condition,
                                                                           std::uint64_t realisations) const;

 private:
  explicit Store(sqlite::Database database) : database_(std::move(database)) {}
  [[nodiscard]] static Store made(sqlite::Database database, const Identity& identity);
  [[nodiscard]] static Store read(sqlite::Database database);
  [[nodiscard]] Row sound_row(const sqlite::Statement& statement) const;
  void walk(sqlite::Statement statement, const std::function<void(const RealisationKey&, const Summary&)>& use) const;

  sqlite::Database database_;
  std::int64_t layout_ = current_layout;
  Identity identity_;
  RowFormat rows_{std::string()};
  Journalling journalling_ = Journalling::write_ahead;
  std::optional<sqlite::Statement> insert_;
  mutable std::optional<sqlite::Statement> find_;
  bool in_transaction_ = false;
};

}  // namespace rocking::experiment
