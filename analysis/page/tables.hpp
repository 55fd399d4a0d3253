#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Rows that a table of a page shows at most; the files that `rocking report` writes have them all.
inline constexpr std::size_t most_rows = 2000;

enum class ModeCells : std::uint8_t { estimates, with_intervals };

/// A row a condition, a column a response mode that occurs anywhere, in per cent: a sortable table.
[[nodiscard]] std::string mode_table_html(const RunReport& report, ModeCells cells);

/// Tables whose first column is a place and whose second a level that holds until the next, as one: a row for each place of
/// any of them, in order; a column for each, called as it is.
[[nodiscard]] Table side_by_side(const std::vector<Table>& tables);

/// A table of a figure, sortable.
[[nodiscard]] std::string data_table_html(const Table& table, const std::string& title);

}  // namespace rocking::analysis
