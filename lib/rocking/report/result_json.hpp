#pragma once

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/report/json.hpp"

namespace rocking::report {

/// One entry of `result.conditions`.
[[nodiscard]] Json condition_json(const experiment::Condition& condition, const experiment::ConditionResult& result);

/// One entry of `internal.conditions`, or its total: what was computed, effect by effect.
[[nodiscard]] Json effort_json(const experiment::Effort& effort, const experiment::Clamps& clamps);

}  // namespace rocking::report
