#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/output/infer_report.hpp"

namespace rocking::analysis {

/// What counted tests say of unknown numbers: the likelihood of each, their joint region, whether the estimate explains
/// the counts, and which test would tell most. Empty without an answer.
[[nodiscard]] std::vector<Figure> infer_figures(const InferReport& report);

}  // namespace rocking::analysis
