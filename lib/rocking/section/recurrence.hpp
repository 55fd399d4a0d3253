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

/// Number of rocking cycles in n periods, and its regularity.
struct Rocks {
  int rocks = 0;               ///< m: pairs of impacts in n periods, rounded up
  double regular_share = 0.0;  ///< share of the cycles that have the typical number of impacts
};

/// Counts over non-overlapping cycles of `length` periods, of which the last ends with the last period; remaining
/// periods at the beginning are not used. The typical number is the median. An impact near a strobe instant can fall
/// before or after it. Therefore a cycle with one impact more or fewer is regular as long as the running total stays
/// within one impact of the typical rate. A cycle without impacts is regular only if the block moved in it. Needs at
/// least one cycle.
[[nodiscard]] Rocks count_rocks(std::span<const Period> periods, int length);

}  // namespace rocking::section
