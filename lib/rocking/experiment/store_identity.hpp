#pragma once

#include <optional>
#include <string>

#include "rocking/experiment/shard.hpp"
#include "rocking/experiment/sqlite.hpp"

namespace rocking::experiment {

/// What a store belongs to. Realisations of one experiment and one code may be put together, others not.
struct Identity {
  std::string experiment;  ///< canonical text, with the seed
  std::string code;        ///< version and revision of what simulated
  std::string files;       ///< folder from which the files that the experiment names are seen; may differ between parts
  std::optional<Shard> shard;  ///< which part of the experiment is to be done here; absent: all of it
};

/// The table of one row that keeps an identity, the format of the draws and a checksum over all of it, as CREATE TABLE
/// writes it.
[[nodiscard]] std::string identity_table();

void write_identity(sqlite::Database& database, const Identity& identity);

/// Throws sqlite::UnusableFile where the row is not what was written, or speaks of other draws than this program's.
[[nodiscard]] Identity read_identity(const sqlite::Database& database);

}  // namespace rocking::experiment
