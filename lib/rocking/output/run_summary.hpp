#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"

namespace rocking {

/// The conditions of a run in at most `most` rows: neighbours with the same most frequent response together, or, if these
/// are still too many, all conditions with equal values of the first entries of the sweep. Empty without rows.
[[nodiscard]] std::string run_summary(std::span<const TableRow> conditions, std::size_t most = most_screen_rows);

/// Of a suite of ground motions: the mean over the records of the share that overturned, at each value of the rest of the
/// sweep, with the smallest and the largest share of a record; at most `most` rows. Empty without a suite.
[[nodiscard]] std::string pooled_summary(std::span<const TableRow> conditions, std::size_t most = most_screen_rows);

}  // namespace rocking
