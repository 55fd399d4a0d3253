#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/store/realisation_key.hpp"
#include "rocking/store/sqlite.hpp"

namespace rocking {

/// Number of the last change of this program that changed the bits of the result of any realisation. Increase it with
/// every such change (the digests of tests/golden show one). Realisations of different results versions are never mixed.
///
/// 1: revision 61b81ca.
/// 2: a block that stops slipping slips on where sticking would need N <= 0 but slipping keeps the contact.
/// 3: the Lyapunov exponent follows from tangent vectors.
/// 4: the records of a suite have independent random numbers.
/// 5: labels (m,n) are those of orbits, and exponents in lanes those of the realisation alone.
/// 6: a block that sticks without contact slips as soon as that presses it on the base, with a sample there or not.
/// 7: an impact at the strobe doubles no period, and slow orbits of 13 to 24 periods are not quasi-periodic.
/// 8: an impact at a wall whose ratio of the rates is 0 leaves no rate.
/// 9: a chatter that a strobe instant cuts is one impact of an orbit.
/// 10: a chatter that the end of a window cuts does not keep a response that repeats from its label.
inline constexpr std::uint64_t results_version = 10;

/// What a store belongs to. Only realisations of the same experiment and results version may be combined.
struct Identity {
  std::string experiment;  ///< canonical text, with the seed
  std::string code;        ///< version and revision of the program that created the store
  std::string files;       ///< folder to which the file names in the experiment are relative; may differ between parts
  std::optional<Shard> shard;               ///< part of the experiment to be run here; absent: all of it
  std::uint64_t results = results_version;  ///< results version of the realisations
};

/// CREATE TABLE statement of the table with one row that holds the identity, the format of the draws and a checksum
/// over both.
[[nodiscard]] std::string identity_table();

void write_identity(sqlite::Database& database, const Identity& identity);

/// Reads the identity from a store. Throws sqlite::UnusableFile if it is not what was written, or
/// if the store uses another format of draws than this program.
[[nodiscard]] Identity read_identity(const sqlite::Database& database);

// The layout of a store: its tables and what its checksums cover. Its number (summary.hpp) is stored in PRAGMA
// user_version. This program reads its own layout.

/// Turns an empty database into a store without rows and identity.
void lay_out(sqlite::Database& database);

/// Throws sqlite::UnusableFile if the database is not a store, has another layout, or contains anything besides the two
/// tables, such as triggers.
void expect_current_layout(const sqlite::Database& database);

}  // namespace rocking
