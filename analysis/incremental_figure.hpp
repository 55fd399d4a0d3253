#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// The figure `incremental` of the incremental dynamic analyses in the output of `rocking fragility --ida`: for each
/// analysis a panel with the peak tilt against the intensity. Thin lines are the medians of the records, thick ones the
/// 16, 50 and 84 % quantiles of all; an overturned block is drawn at a flat line above all tilts. Empty if the output
/// has no such analysis. Throws base::InputError if `output` is no such output.
[[nodiscard]] std::vector<Figure> incremental_figures(const Json& output);

}  // namespace rocking::analysis
