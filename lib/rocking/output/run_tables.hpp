#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "rocking/output/condition_table.hpp"

namespace rocking {

/// The tables of a run; what is empty is not among them.
///
/// | name | for | a row is |
/// | --- | --- | --- |
/// | `modes` | LaTeX, page | a condition, with a column for each of the most frequent modes; on a page for all |
/// | `modes` | CSV | a condition and a mode that any condition lists, with the interval shown in figures |
/// | `non_recurrence` | CSV | a condition; divergence times in periods |
/// | `quantiles` | CSV | a condition, a quantity and a level |
/// | `settling`, `leaving`, `long_run_shares` | | see settling_table(), leaving_table(), long_run_table() |
///
/// The terminal has these too, as far as its width allows: run_table().
[[nodiscard]] std::vector<RunTable> tables_of(const Report& report);

/// Of them in the formats `csv` and `latex`, as far as they are asked for: text by the name of the file. `incidence.csv`
/// has a line for each condition, response mode and period at which its cumulative incidence changes; the mode `any` is
/// that of having settled, `diverged` the divergence of pairs.
[[nodiscard]] std::map<std::string, std::string> table_files(const Report& report,
                                                             const std::set<std::string>& formats);

/// The response modes for LaTeX or for a page.
[[nodiscard]] RunTable response_table(const Report& report, look::Media medium);

}  // namespace rocking
