#pragma once

#include <string>

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The numbers of a figure as text: a block for each table, separated by two empty lines. A block has comment lines
/// with its name, the meaning of each column and the column names, then a line for each row. Columns are separated by
/// tabs; text is quoted.
[[nodiscard]] std::string data_text(const Figure& figure);

}  // namespace rocking::analysis
