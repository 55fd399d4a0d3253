#pragma once

#include <cstdint>
#include <string>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Rows that a table of a page shows at most; the files that `rocking report` writes have them all.
inline constexpr std::size_t most_rows = 2000;

enum class ModeCells : std::uint8_t { estimates, with_intervals };

/// A row a condition, a column a response mode that occurs anywhere, in per cent: a sortable table.
[[nodiscard]] std::string mode_table_html(const RunReport& report, ModeCells cells);

/// A table of a figure, sortable.
[[nodiscard]] std::string data_table_html(const Table& table, const std::string& title);

}  // namespace rocking::analysis
