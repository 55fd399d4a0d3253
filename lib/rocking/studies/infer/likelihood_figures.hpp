#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/infer/result.hpp"

namespace rocking::analysis {

/// The likelihood over the largest one against each unknown, with the intervals and the estimate; a panel for each
/// unknown. Needs an answer.
[[nodiscard]] Figure profile_figure(const InferReport& report);

/// The joint region of two or three unknowns as a map of the likelihood over the largest one, with the estimate; a
/// panel for each pair. Needs an answer.
[[nodiscard]] Figure region_figure(const InferReport& report);

}  // namespace rocking::analysis
