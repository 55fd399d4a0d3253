#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/report.hpp"

namespace rocking {

/// A run as text for a terminal: its title, the table of response modes with its legend, and a line each on
/// overturning, settling, precision that was not reached, sensitivity to the tolerance, and warnings.
[[nodiscard]] std::string run_table(const Report& report, const TableLook& look = {});

/// The largest Lyapunov exponents of the conditions whose classification needed some, as a table with a legend; empty
/// without any.
[[nodiscard]] std::string exponent_table(const Report& report);

/// Overturning to the left and to the right in the conditions where it occurs, as a table with a legend; empty without any,
/// and where no block has unlike edges.
[[nodiscard]] std::string side_table(const Report& report);

/// The conditions of a run in at most `most` rows: neighbours with the same most frequent response together, or, if these
/// are still too many, all conditions with equal values of the first entries of the sweep. Empty without rows.
[[nodiscard]] std::string run_summary(std::span<const TableRow> conditions, std::size_t most = most_screen_rows);

/// Of a suite of ground motions: the mean over the records of the share that overturned, at each value of the rest of the
/// sweep, with the smallest and the largest share of a record; at most `most` rows. Empty without a suite.
[[nodiscard]] std::string pooled_summary(std::span<const TableRow> conditions, std::size_t most = most_screen_rows);

}  // namespace rocking
