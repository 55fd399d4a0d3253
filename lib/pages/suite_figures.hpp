#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/store.hpp"

namespace rocking::pages {

/// Fragility and incremental dynamic analysis of a suite of ground motions, as `rocking fragility --ida` draws them. Empty
/// if its sweep has no intensity, or with `until`.
[[nodiscard]] std::vector<analysis::Figure> suite_figures(const Experiment& experiment, const Store& store,
                                                          unsigned threads = 1);

/// Whether the swept parameters are those of a suite of ground motions.
[[nodiscard]] bool is_suite(const std::vector<std::string>& swept);

}  // namespace rocking::pages
