#pragma once

#include <cstdint>

#include "rocking/store/sqlite.hpp"

/// The layout of a store: its tables and what its checksums cover. Its number is stored in PRAGMA user_version. This
/// program reads its own layout. A new or renamed field of a row (for_each_field) needs a new number.
namespace rocking {

inline constexpr std::int64_t current_layout = 7;

/// Turns an empty database into a store without rows and identity.
void lay_out(sqlite::Database& database);

/// Throws sqlite::UnusableFile if the database is not a store, has another layout, or contains anything besides the two
/// tables, such as triggers.
void expect_current_layout(const sqlite::Database& database);

}  // namespace rocking
