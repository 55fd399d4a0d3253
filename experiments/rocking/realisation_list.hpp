#pragma once

#include <string>
#include <vector>

#include "rocking/store/summary.hpp"

namespace rocking::program {

/// `condition 0: realisations 3-9, 12; condition 2: realisations 4`; of a long list the first ranges, and the number
/// of realisations that follow. `none` for an empty one. The keys are in ascending order.
[[nodiscard]] std::string listed_realisations(const std::vector<RealisationKey>& keys);

}  // namespace rocking::program
