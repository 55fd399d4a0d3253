#pragma once

#include "campaign.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking::program {

/// Prints what a run would do, with its time.
[[nodiscard]] ExitCode show_plan(const Experiment& experiment, const std::optional<Shard>& shard,
                                 const ExecutionOptions& execution);

}  // namespace rocking::program
