#pragma once

#include <optional>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/fragility/result.hpp"

namespace rocking::analysis {

/// The figure `incremental`: for each incremental dynamic analysis a panel with the peak tilt against the intensity. Thin
/// lines are the medians of the records, thick ones the 16, 50 and 84 % quantiles of all; an overturned block is drawn at
/// a flat line above all tilts. Absent if the report has no such analysis.
[[nodiscard]] std::optional<Figure> incremental_figure(const FragilityReport& report);

}  // namespace rocking::analysis
