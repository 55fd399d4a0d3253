#pragma once

#include <cstdint>

#include "rocking/experiment/sqlite.hpp"

/// Layouts of a store: which tables it has and what its checksums cover. A store says its layout in PRAGMA user_version.
/// This program reads every layout up to its own.
///
/// 1: revision 61b81ca, whose stores say 0. Without results version; a row's checksum covers its key and fields.
/// 2: a row's checksum covers the experiment too.
///
/// A new field of a row (for_each_field) is a new layout: stores of earlier ones lack its column, and it reads as its
/// default there.
namespace rocking::experiment {

inline constexpr std::int64_t current_layout = 2;

/// Makes an empty database a store without rows and identity.
void lay_out(sqlite::Database& database);

/// The layout of a store. Throws sqlite::UnusableFile where it is no store, where it is of a later layout, and where it
/// holds anything besides the two tables, as triggers.
[[nodiscard]] std::int64_t layout_of(const sqlite::Database& database);

}  // namespace rocking::experiment
