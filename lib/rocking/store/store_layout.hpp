#pragma once

#include <cstdint>

#include "rocking/store/sqlite.hpp"

/// Layouts of a store: its tables and what its checksums cover. The layout is stored in PRAGMA user_version. This
/// program reads all layouts up to its own.
///
/// 1: revision 61b81ca, whose stores have user_version 0. No results version; the checksum of a row covers its key and
/// fields.
/// 2: the checksum of a row also covers the experiment.
/// 3: the column clamped_length_at_bound.
/// 4: the columns of peaks and slip, peak_tilt to final_slip_m, and left_ground_before_fall.
/// 5: the columns of realisations run until they are classified, horizon_mode to left_to.
/// 6: the column long_run.
///
/// A new field of a row (for_each_field) needs a new layout. Stores of earlier layouts lack its column; the field then
/// has its default value.
namespace rocking {

inline constexpr std::int64_t current_layout = 6;

/// Turns an empty database into a store without rows and identity.
void lay_out(sqlite::Database& database);

/// The layout of a store. Throws sqlite::UnusableFile if the database is not a store, has a later layout, or contains
/// anything besides the two tables, such as triggers.
[[nodiscard]] std::int64_t layout_of(const sqlite::Database& database);

}  // namespace rocking
