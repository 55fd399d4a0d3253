#pragma once

#include <vector>

#include "rocking/experiment/mode_family.hpp"
#include "rocking/experiment/result.hpp"

namespace rocking::experiment {

/// Probabilities of the modes listed, with their intervals at this number of realisations, at least 1.
[[nodiscard]] std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence);

}  // namespace rocking::experiment
