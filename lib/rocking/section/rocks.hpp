#pragma once

#include <span>

#include "rocking/section/classification.hpp"

namespace rocking::section {

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
