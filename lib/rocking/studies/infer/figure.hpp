#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/infer/result.hpp"

namespace rocking::analysis {

/// What counted tests say of unknown numbers: the likelihood of each, their joint region, whether the estimate explains
/// the counts, and which test would tell most. Empty without an answer.
[[nodiscard]] std::vector<Figure> infer_figures(const InferReport& report);

}  // namespace rocking::analysis
