#pragma once

#include <cstddef>
#include <string>

#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/report.hpp"

namespace rocking {

/// A run as text for a terminal: its title, the table of response modes with its legend, and a line each on
/// overturning, settling, precision that was not reached, sensitivity to the tolerance, and warnings.
[[nodiscard]] std::string run_table(const Report& report, const TableLook& look = {});

/// The tables of a run with all conditions and modes, without their legends.
[[nodiscard]] std::string tables_in_full(const Report& report, const TableLook& look = {});

/// The conditions of a run in at most `most` rows: neighbours with the same most frequent response together, or, if these
/// are still too many, all conditions with equal values of the first entries of the sweep.
[[nodiscard]] std::string run_summary(const Report& report, std::size_t most = most_screen_rows);

/// Of a suite of ground motions: the mean over the records of the share that overturned, at each value of the rest of the
/// sweep, with the smallest and the largest share of a record; at most `most` rows. Empty without a suite.
[[nodiscard]] std::string pooled_summary(const Report& report, std::size_t most = most_screen_rows);

}  // namespace rocking
