#pragma once

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/json.hpp"
#include "rocking/report/write_report.hpp"

/// What files say of where they come from.
namespace rocking::report {

/// `input`: the experiment with every default written out, and its digest.
[[nodiscard]] Json input_json(const experiment::Experiment& experiment);

/// `system`: what may differ between equal runs.
[[nodiscard]] Json system_json(const SystemFacts& system);

}  // namespace rocking::report
