#pragma once

#include <string>

#include "analysis/figure.hpp"

namespace rocking::analysis {

/// The shortest decimal text of a number that reads back to the same bits.
[[nodiscard]] std::string number_text(double number);

/// A cell as text for data files and tables: an empty cell is `NaN`, text is unchanged.
[[nodiscard]] std::string cell_text(const Cell& cell);

/// The numbers of a figure as text: a block for each table, separated by two empty lines. A block has comment lines
/// with its name, the meaning of each column and the column names, then a line for each row. Columns are separated by
/// tabs; text is quoted.
[[nodiscard]] std::string data_text(const Figure& figure);

}  // namespace rocking::analysis
