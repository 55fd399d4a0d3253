#pragma once

#include <optional>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/noise_floor.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/report/json.hpp"

namespace rocking::report {

/// `[low, high]`.
[[nodiscard]] Json interval_json(const stats::Interval& interval);

/// JSON pointer to value, for each entry of the sweep.
[[nodiscard]] Json parameters_json(const experiment::Condition& condition);

/// One entry of `result.conditions`.
[[nodiscard]] Json condition_json(const experiment::Condition& condition, const experiment::ConditionResult& result);

/// `result.noise_floor`; null where there is none.
[[nodiscard]] Json noise_floor_json(const std::optional<experiment::NoiseFloor>& floor);

/// One entry of `internal.conditions`, or its total: what was computed, effect by effect.
[[nodiscard]] Json effort_json(const experiment::Effort& effort, const experiment::Clamps& clamps);

}  // namespace rocking::report
