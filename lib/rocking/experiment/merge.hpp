#pragma once

#include <vector>

#include "rocking/experiment/store.hpp"
#include "rocking/experiment/verification.hpp"

namespace rocking::experiment {

/// Adds the realisations of one store to another. Those that both have must be the same; the ones that are not are
/// returned, in their order. What was added is not yet durable.
[[nodiscard]] std::vector<Difference> merge(Store& into, const Store& from);

}  // namespace rocking::experiment
