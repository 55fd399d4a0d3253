#pragma once

#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/studies/fragility/question.hpp"

namespace rocking {

/// The curves of a run from its stripes: for each group, for each event. Throws base::InputError if the hazard curve is one
/// of another intensity, or if metadata are given without a suite or not for each of its records, and base::Stopped if it is asked to stop. Uses `threads`, `stop_requested` and `on_progress` of
/// the options; progress counts parts of about equal work, most of them bootstrap samples.
[[nodiscard]] RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& groups,
                                         const FragilityQuestion& question, const RunOptions& options);

}  // namespace rocking
