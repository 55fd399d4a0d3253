#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/studies/rare/question.hpp"

namespace rocking::rare {

/// Fewer repetitions have the interval [0, 1]: one from fewer has not been tested. So many are made before the share of a
/// condition in the time counts.
inline constexpr std::size_t least_with_interval = 8;

/// Sets what follows from the repetitions: the probability, its error and interval, and the work. `confidence` in (0, 1);
/// `particles`: of a repetition.
void summarise_repetitions(RareEstimate& estimate, double confidence, std::uint64_t particles);

}  // namespace rocking::rare
