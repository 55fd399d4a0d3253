#pragma once

#include <string>

#include "analysis/figure.hpp"

namespace rocking::analysis {

/// The gnuplot (5.4 or later) script that draws NAME.svg, NAME.png and NAME.pdf from NAME.tsv, all in the folder where it is
/// run. `formats` may be set before it, as in `gnuplot -e "formats='svg'" NAME.gp`.
[[nodiscard]] std::string script_text(const Figure& figure);

}  // namespace rocking::analysis
