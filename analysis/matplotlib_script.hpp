#pragma once

#include <string>

#include "analysis/look.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The Python script that draws the figure plainly with matplotlib (version 3.6 or later): `python3 NAME.py` reads
/// NAME.tsv in the current folder and writes NAME-matplotlib.pdf.
[[nodiscard]] std::string matplotlib_text(const Figure& figure, const FigureLook& look = screen_look());

}  // namespace rocking::analysis
