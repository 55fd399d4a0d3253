#pragma once

#include <string>
#include <string_view>

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

/// The Python script that draws the figure plainly with matplotlib (version 3.6 or later): `python3 NAME.py` reads
/// NAME.tsv in the current folder and writes NAME-matplotlib.pdf.
[[nodiscard]] std::string matplotlib_text(const Figure& figure, const FigureLook& look = screen_look());

/// A text in which matplotlib finds no formula.
[[nodiscard]] std::string without_formulas(std::string_view text);

/// A Python string of this text.
[[nodiscard]] std::string python_quoted(const std::string& text);

/// The call that draws a layer on `ax`, with an entry in the legend if `label` is not empty. It uses `tables`,
/// `columns`, `boxes` and `bars` of the script.
[[nodiscard]] std::string matplotlib_call(const Figure& figure, const Layer& layer, const std::string& label);

}  // namespace rocking::analysis
