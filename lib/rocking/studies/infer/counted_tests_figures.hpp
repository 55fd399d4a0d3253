#pragma once

#include <optional>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/infer/result.hpp"

namespace rocking::analysis {

/// Counted shares of the groups of response modes beside those that the estimate predicts; a panel for each of the
/// first 48 tested conditions. Needs an answer.
[[nodiscard]] Figure fit_figure(const InferReport& report);

/// By how much tests under each candidate condition are expected to narrow the region and each unknown. Needs an
/// answer; nothing without candidates.
[[nodiscard]] std::optional<Figure> candidates_figure(const InferReport& report);

}  // namespace rocking::analysis
