#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rocking/studies/fragility/run_fragility.hpp"

namespace rocking {

/// The place of an estimate of a probability that one before it has estimated too: a curve would join them. Absent if there
/// is none.
[[nodiscard]] std::optional<std::size_t> second_estimate(const std::vector<RareOfCurve>& rare);

}  // namespace rocking
