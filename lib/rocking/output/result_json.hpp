#pragma once

#include <optional>

#include "rocking/ensemble/result.hpp"
#include "rocking/ensemble/tolerance_sensitivity.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// `[low, high]`.
[[nodiscard]] Json interval_json(const stats::Interval& interval);

/// JSON pointer to value, for each entry of the sweep.
[[nodiscard]] Json parameters_json(const Condition& condition);

/// One entry of `result.conditions`.
[[nodiscard]] Json condition_json(const Condition& condition, const ConditionResult& result);

/// `result.tolerance_sensitivity`; null if nothing was rerun.
[[nodiscard]] Json tolerance_sensitivity_json(const std::optional<ToleranceSensitivity>& floor);

/// One entry of `internal.conditions`, or `internal.total`: operation counts by effect.
[[nodiscard]] Json operation_counts_json(const OperationCounts& operations, const Clamps& clamps);

}  // namespace rocking
