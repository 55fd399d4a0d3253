#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Figures of the output of `rocking cost`: `cost_tolerance`, error, changed response modes and time against the
/// tolerance; `work_precision`, error against time; `cost_realisations`, half-widths against time, if anything is
/// random. Throws base::InputError if `output` is no such output.
[[nodiscard]] std::vector<Figure> cost_figures(const Json& output);

}  // namespace rocking::analysis
