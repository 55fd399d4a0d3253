#pragma once

#include <cstdint>
#include <optional>

#include "rocking/realisation/realisation_result.hpp"

namespace rocking {

/// First period, counted from 1, in which the two results have diverged: their strobe points are more than 0.01 apart
/// in (Theta, Theta'), or only one of the runs has ended. Absent if they have not diverged.
[[nodiscard]] std::optional<std::int64_t> divergence_period(const RealisationResult& a, const RealisationResult& b);

}  // namespace rocking
