#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Every figure that a report has the numbers for, in the order in which a reader wants them.
[[nodiscard]] std::vector<Figure> run_figures(const RunReport& report);

}  // namespace rocking::analysis
