#pragma once

#include <vector>

#include "rocking/store/difference.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// Adds the realisations of one store to another. Realisations present in both must be equal; those that are not are
/// returned, in order. The added rows are not yet durable.
[[nodiscard]] std::vector<Difference> merge(Store& into, const Store& from);

}  // namespace rocking
