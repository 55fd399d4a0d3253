#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/experiment/sqlite.hpp"
#include "rocking/experiment/summary.hpp"

/// How a summary becomes a row of a store and is read back.
namespace rocking::experiment {

/// The table of the rows, as CREATE TABLE writes it.
[[nodiscard]] std::string row_table();

struct Row {
  RealisationKey key;
  Summary summary;
};

/// The rows of one store: which of today's columns it has, and what a row's checksum covers.
class RowFormat {
 public:
  /// That of a new store.
  explicit RowFormat(const std::string& experiment);
  /// That of a store as it is. Columns that it lacks read as the default of their field.
  RowFormat(const sqlite::Database& database, std::int64_t layout, const std::string& experiment);

  /// Names of all its columns, as SELECT and INSERT take them: the key, the fields, the checksum.
  [[nodiscard]] const std::string& columns() const { return columns_; }
  /// `?, ?, ...`, one for each column.
  [[nodiscard]] std::string placeholders() const;

  /// Binds all columns of a row.
  void bind(sqlite::Statement& statement, const RealisationKey& key, const Summary& summary) const;
  /// Reads all columns. Absent if they are not what `bind` was given.
  [[nodiscard]] std::optional<Row> read(const sqlite::Statement& statement) const;

 private:
  template <class Visit, class SomeSummary>
  void for_each_stored_field(SomeSummary& summary, Visit&& visit) const;
  [[nodiscard]] std::uint64_t checksum_of(const RealisationKey& key, const Summary& summary) const;
  void list_columns();

  std::vector<bool> is_stored_;             ///< by field, in the order of for_each_field
  std::optional<base::Sha256> experiment_;  ///< digest of the experiment's text, from layout 2 on
  std::string columns_;
};

}  // namespace rocking::experiment
