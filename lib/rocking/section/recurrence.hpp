#pragma once

#include <optional>
#include <span>

#include "rocking/section/period.hpp"
#include "rocking/section/thresholds.hpp"
#include "rocking/section/verdict.hpp"

namespace rocking::section {

/// What the strobe points of a noise-free response say by themselves.
///
/// Periodic, or unresolved because it still converges or its impacts are irregular; nothing where no n <= 12 brings the
/// points together, so that the exponent has to speak. Expects at least 24 periods.
[[nodiscard]] std::optional<Verdict> find_recurrence(std::span<const Period> periods, double resolution,
                                                     const Thresholds& thresholds = {});

}  // namespace rocking::section
