#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// What `rocking cost` measured: `cost_tolerance`, error, changed response modes and time against the tolerance;
/// `work_precision`, error against time; `cost_realisations`, half-widths against time, where something is drawn. Throws
/// base::InputError where it is no such file.
[[nodiscard]] std::vector<Figure> cost_figures(const report::Json& output);

}  // namespace rocking::analysis
