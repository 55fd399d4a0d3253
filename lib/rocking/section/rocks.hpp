#pragma once

#include <span>

#include "rocking/section/period.hpp"

namespace rocking::section {

/// How many times a block rocks in a cycle of n periods, and how steadily.
struct Rocks {
  int rocks = 0;               ///< m: pairs of impacts in a cycle, a pair begun counted
  double regular_share = 0.0;  ///< of the cycles, those that keep to the typical number of impacts
};

/// Counts over the non-overlapping cycles of `length` periods that end with the last period; earlier ones left over are
/// not used. Typical is the median. An impact near a strobe instant falls now before it, now after: a cycle that is one
/// impact short or over is regular as long as the running total stays within one impact of the typical pace. A cycle
/// without impacts is regular only if the block moved in it.
/// Expects at least one cycle.
[[nodiscard]] Rocks count_rocks(std::span<const Period> periods, int length);

}  // namespace rocking::section
