#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rocking/section/classification.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// What the returns of a noise-free response say.
struct Recurrence {
  /// Periodic where the points alone decide: they repeat after n periods, and after no divisor of n do they come anywhere
  /// near. Unresolved where they repeat but the impacts do not. Absent otherwise.
  std::optional<Classification> classification;
  /// Numbers of periods, in increasing order, after which the points come close or ever closer: the period, or on a slow
  /// spiral and near a doubling a multiple of it. None is a multiple of another one.
  std::vector<int> candidates;
};

/// Compares points 1 ... 12 periods apart. Needs at least 24 periods. Where they repeat, and the impacts do not, those of
/// the last `unfinished` periods are not counted: they may be of a chatter that the end cuts.
[[nodiscard]] Recurrence find_recurrence(std::span<const Period> periods, double resolution,
                                         const Thresholds& thresholds = {}, std::size_t unfinished = 0);

/// Whether points some number of periods up to 12 apart come closer from third to third, however slowly: by a twentieth.
[[nodiscard]] bool come_closer(std::span<const StrobePoint> points);

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
