#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"

/// How far the block tilts and slips, as quantiles over the realisations of each condition.
namespace rocking::analysis {

/// `peak_tilt` and, where the block can slide, `peak_slip` and `final_slip`: median with its interval, and the outer
/// quantiles, against the swept parameter. Empty for reports without them.
[[nodiscard]] std::vector<Figure> quantile_figures(const Report& report);

/// The same numbers of one condition, with a row for each quantity; of one realisation its values.
[[nodiscard]] Table quantiles_of_condition(const Report& report, const ReportedCondition& condition);

}  // namespace rocking::analysis
