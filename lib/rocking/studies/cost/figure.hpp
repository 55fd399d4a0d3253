#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/cost/result.hpp"

namespace rocking::analysis {

/// Figures of the output of `rocking cost`: `cost_tolerance`, error, changed response modes and time against the
/// tolerance; `work_precision`, error against time; `cost_realisations`, half-widths against time, if anything is
/// random.
[[nodiscard]] std::vector<Figure> cost_figures(const CostReport& report);

}  // namespace rocking::analysis
