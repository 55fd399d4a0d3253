#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::analysis {

/// Every figure that a report has the numbers for, in the order in which a reader wants them. With the store of its
/// realisations also those for which a report is too short.
[[nodiscard]] std::vector<Figure> run_figures(const RunReport& report, const experiment::Store* store = nullptr);

}  // namespace rocking::analysis
