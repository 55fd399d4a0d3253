#pragma once

#include <string>

#include "analysis/look.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The gnuplot script (version 5.4 or later) that draws NAME.svg, NAME.png and NAME.pdf from NAME.tsv in the current
/// folder. `formats` can be set before, as in `gnuplot -e "formats='svg'" NAME.gp`.
[[nodiscard]] std::string script_text(const Figure& figure, const FigureLook& look = screen_look());

}  // namespace rocking::analysis
