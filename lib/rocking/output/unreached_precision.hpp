#pragma once

#include <string>

#include "rocking/output/report.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Text for a terminal on the conditions that ended at their largest number of realisations before the half-width of
/// `until` was reached: their number, the first few with the half-width that they have, and what to do. Ends with a
/// line break; empty without such conditions.
[[nodiscard]] std::string unreached_precision(const Experiment& experiment, const Report& report);

}  // namespace rocking
