#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/store/store.hpp"

namespace rocking::analysis {

/// `divergence_times`: the share of pairs of runs that have diverged by each period, a curve for each condition with
/// pairs. Of more than seven conditions, the seven are shown in which two runs differ most often in response mode. It
/// needs the realisations, which a report does not contain. Absent if no pair has diverged.
[[nodiscard]] std::optional<Figure> divergence_times(const Report& report, const Store& store);

}  // namespace rocking::analysis
