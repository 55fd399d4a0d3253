#pragma once

#include <string>

#include "analysis/figure.hpp"

namespace rocking::analysis {

/// A number in the shortest spelling that reads back to the same bits.
[[nodiscard]] std::string number_text(double number);

/// A cell as data files and tables show it: nothing is `NaN`, text stands as it is.
[[nodiscard]] std::string cell_text(const Cell& cell);

/// The figure's numbers as text: a block for each table, two empty lines between them. A block has commented lines with its
/// name, the meaning of each column and their names, then a line for each row, columns divided by tabs. Text is quoted.
[[nodiscard]] std::string data_text(const Figure& figure);

}  // namespace rocking::analysis
