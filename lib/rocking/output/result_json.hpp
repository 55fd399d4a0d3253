#pragma once

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// `[low, high]`.
[[nodiscard]] Json interval_json(const stats::Interval& interval);

/// JSON pointer to value, for each entry of the sweep.
[[nodiscard]] Json parameters_json(const Condition& condition);

}  // namespace rocking
