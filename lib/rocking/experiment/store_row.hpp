#pragma once

#include <string>

#include "rocking/experiment/sqlite.hpp"
#include "rocking/experiment/summary.hpp"

/// How a summary becomes a row of a store and is read back.
namespace rocking::experiment {

/// Names and types of all columns, as CREATE TABLE takes them.
[[nodiscard]] std::string column_definitions();
/// `(?, ?, ...)`, one for each column.
[[nodiscard]] std::string column_placeholders();

/// Binds all columns of a row.
void bind_row(sqlite::Statement& statement, const RealisationKey& key, const Summary& summary);

struct Row {
  RealisationKey key;
  Summary summary;
};

/// Reads all columns. Absent if they are not what bind_row was given.
[[nodiscard]] std::optional<Row> read_row(const sqlite::Statement& statement);

}  // namespace rocking::experiment
