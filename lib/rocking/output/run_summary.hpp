#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "rocking/output/mode_table.hpp"

namespace rocking {

/// Most rows of the tables of a run on a terminal, unless all are asked for.
inline constexpr std::size_t most_summary_rows = 40;

/// The conditions of a run in at most `most` rows: neighbours with the same most frequent response together, or, if these
/// are still too many, all conditions with equal values of the first entries of the sweep. Empty without rows.
[[nodiscard]] std::string run_summary(std::span<const TableRow> conditions, std::size_t most = most_summary_rows);

/// Of a suite of ground motions: the mean over the records of the share that overturned, at each value of the rest of the
/// sweep, with the smallest and the largest share of a record; at most `most` rows. Empty without a suite.
[[nodiscard]] std::string pooled_summary(std::span<const TableRow> conditions, std::size_t most = most_summary_rows);

}  // namespace rocking
