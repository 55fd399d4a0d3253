#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/store/summary.hpp"

/// Conversion of a summary to a row of a store and back.
namespace rocking {

/// CREATE TABLE statement of the table of rows.
[[nodiscard]] std::string row_table();

struct Row {
  RealisationKey key;
  Summary summary;
};

/// Format of the rows of one store: which of the current columns it has and what the checksum of a row covers.
class RowFormat {
 public:
  /// The format of a new store.
  explicit RowFormat(const std::string& experiment);
  /// The format of an existing store. Columns that it lacks are read as the defaults of their fields.
  RowFormat(const sqlite::Database& database, std::int64_t layout, const std::string& experiment);

  /// Names of all columns, as for SELECT and INSERT: the key, the fields, the checksum.
  [[nodiscard]] const std::string& columns() const { return columns_; }
  /// `?, ?, ...`, one for each column.
  [[nodiscard]] std::string placeholders() const;

  /// Binds all columns of a row.
  void bind(sqlite::Statement& statement, const RealisationKey& key, const Summary& summary) const;
  /// Reads all columns. Absent if they are not those that were bound.
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

}  // namespace rocking
