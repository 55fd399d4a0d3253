#pragma once

#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/look/table.hpp"
#include "rocking/output/run_tables.hpp"

namespace rocking::analysis {

/// Largest number of rows of a table of a page; the files that `rocking report` writes have all rows.
inline constexpr std::size_t most_rows = 2000;

/// A sortable table with a row for each condition and a column for each response mode that occurs, in per cent with
/// intervals; `< 2.8` where it does not occur. If nothing is random, one column with the response instead.
[[nodiscard]] std::string mode_table_html(const Report& report);

/// Joins step functions into one table. The first column of each table is a place, the second a level that holds until
/// the next place. The result has a row for each place of any table, in order, and a column for each table, with its
/// name.
[[nodiscard]] Table side_by_side(const std::vector<Table>& tables);

/// A table of a page, sortable; empty without rows. `label`: what it is, for readers who cannot see it.
[[nodiscard]] std::string table_html(const RunTable& table, const std::string& label);

/// The table of a figure, sortable.
[[nodiscard]] std::string data_table_html(const Table& table, const std::string& title);

}  // namespace rocking::analysis
