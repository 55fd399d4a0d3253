#pragma once

#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/result.hpp"

namespace rocking {

/// Probabilities of the listed modes with their intervals, for a fixed number of realisations >= 1. `confidence` in (0,
/// 1).
[[nodiscard]] std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence);

}  // namespace rocking
