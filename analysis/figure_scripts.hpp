#pragma once

#include <string>

#include "analysis/look.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The numbers of a figure as text: a block for each table, separated by two empty lines. A block has comment lines
/// with its name, the meaning of each column and the column names, then a line for each row. Columns are separated by
/// tabs; text is quoted.
[[nodiscard]] std::string data_text(const Figure& figure);

/// The gnuplot script (version 5.4 or later) that draws NAME.svg, NAME.png and NAME.pdf from NAME.tsv in the current
/// folder. `formats` can be set before, as in `gnuplot -e "formats='svg'" NAME.gp`.
[[nodiscard]] std::string script_text(const Figure& figure, const FigureLook& look = screen_look());

}  // namespace rocking::analysis
