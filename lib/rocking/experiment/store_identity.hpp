#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/experiment/results_version.hpp"
#include "rocking/experiment/shard.hpp"
#include "rocking/experiment/sqlite.hpp"

namespace rocking::experiment {

/// What a store belongs to. Realisations of one experiment and one results version may be put together, others not.
struct Identity {
  std::string experiment;  ///< canonical text, with the seed
  std::string code;        ///< version and revision of the program that began the store
  std::string files;       ///< folder from which the files that the experiment names are seen; may differ between parts
  std::optional<Shard> shard;               ///< which part of the experiment is to be done here; absent: all of it
  std::uint64_t results = results_version;  ///< results version of its realisations; 0: not known
};

/// The table of one row that keeps an identity, the format of the draws and a checksum over all of it, as CREATE TABLE
/// writes it.
[[nodiscard]] std::string identity_table();

void write_identity(sqlite::Database& database, const Identity& identity);

/// Reads the identity from a store of any known layout. Throws sqlite::UnusableFile where it is not what was written, or
/// where the store has other draws than this program.
[[nodiscard]] Identity read_identity(const sqlite::Database& database, std::int64_t layout);

}  // namespace rocking::experiment
