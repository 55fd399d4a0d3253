#pragma once

#include "rocking/output/write_report.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

/// The parts of a file that describe its origin.
namespace rocking {

/// `input`: the experiment with every default written out, and its digest.
[[nodiscard]] Json input_json(const Experiment& experiment);

/// `system`: the facts that may differ between equal runs.
[[nodiscard]] Json system_json(const SystemFacts& system);

}  // namespace rocking
