#pragma once

#include <optional>
#include <string>

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

/// Names of all columns, as for SELECT and INSERT: the key, the fields, the checksum.
[[nodiscard]] const std::string& row_columns();
/// `?, ?, ...`, one for each column.
[[nodiscard]] std::string row_placeholders();

/// The rows of one store. Their checksums cover the experiment, the key and all fields.
class RowFormat {
 public:
  explicit RowFormat(const std::string& experiment) : experiment_(base::sha256(experiment)) {}

  /// Binds all columns of a row.
  void bind(sqlite::Statement& statement, const RealisationKey& key, const Summary& summary) const;
  /// Reads all columns. Absent if they are not those that were bound.
  [[nodiscard]] std::optional<Row> read(const sqlite::Statement& statement) const;

 private:
  [[nodiscard]] std::uint64_t checksum_of(const RealisationKey& key, const Summary& summary) const;

  base::Sha256 experiment_;  ///< digest of the experiment's text
};

}  // namespace rocking
