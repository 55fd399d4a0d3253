#pragma once

#include <optional>
#include <span>

#include "rocking/section/classification.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// Classifies a noise-free response by its strobe points.
///
/// Periodic; or unresolved because it still converges or its impacts are irregular; or nothing if it repeats for no n
/// <= 12, so that the exponent must decide. Needs at least 24 periods.
[[nodiscard]] std::optional<Classification> find_recurrence(std::span<const Period> periods, double resolution,
                                                            const Thresholds& thresholds = {});

}  // namespace rocking::section
