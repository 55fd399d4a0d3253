#pragma once

#include "rocking/store/sqlite.hpp"

/// The layout of a store: its tables and what its checksums cover. Its number (summary.hpp) is stored in PRAGMA
/// user_version. This program reads its own layout.
namespace rocking {

/// Turns an empty database into a store without rows and identity.
void lay_out(sqlite::Database& database);

/// Throws sqlite::UnusableFile if the database is not a store, has another layout, or contains anything besides the two
/// tables, such as triggers.
void expect_current_layout(const sqlite::Database& database);

}  // namespace rocking
