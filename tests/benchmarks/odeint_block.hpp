#pragma once

#include <cstdint>
#include <optional>

#include "differential/peer/block.hpp"

namespace rocking::benchmarks {

/// State of a symmetric block under a sine after `period_count` periods, by Boost.odeint as its user would write it:
/// dopri5 with plain equations, guards tested after each step, instants of events by bisection on the dense output and
/// Newton steps of the method. Absent where the block overturns.
///
/// Throws std::runtime_error where the block comes to rest, which no case of the benchmarks does.
[[nodiscard]] std::optional<peer::Posture> follow_by_odeint(const peer::Scene& scene, std::int64_t period_count,
                                                            double tolerance);

}  // namespace rocking::benchmarks
