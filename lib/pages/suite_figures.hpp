#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/store/store.hpp"

namespace rocking::pages {

/// Fragility and incremental dynamic analysis of a suite of ground motions, as `rocking fragility --ida` draws them. Empty
/// if its sweep has no intensity, or with `until`. With a hazard curve the fragility tells its annual rates.
[[nodiscard]] std::vector<analysis::Figure> suite_figures(const Experiment& experiment, const Store& store,
                                                          unsigned threads = 1,
                                                          const std::optional<HazardCurve>& hazard = std::nullopt);

/// Whether the swept parameters are those of a suite of ground motions.
[[nodiscard]] bool is_suite(const std::vector<std::string>& swept);

}  // namespace rocking::pages
