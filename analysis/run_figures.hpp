#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/store/store.hpp"

namespace rocking::analysis {

/// All figures for which a report has the numbers, in reading order. With the store of its realisations, also those
/// that need more than the report. One condition has no figures that show numbers along a sweep.
[[nodiscard]] std::vector<Figure> run_figures(const Report& report, const Store* store = nullptr);

}  // namespace rocking::analysis
