#pragma once

#include <cstdint>

#include "rocking/stats/confidence_sequence.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// How the half-width of an interval is measured: as a probability, or relative to the estimate k/n. Relative to an
/// estimate of 0 no half-width is narrow.
enum class HalfWidthScale : std::uint8_t { absolute, relative };

/// Goal of a stopping rule: the wanted precision and the largest number of trials.
struct StoppingGoal {
  double half_width = 0.0;  ///< wanted half-width, in (0, 1/2); relative: in (0, 1)
  HalfWidthScale scale = HalfWidthScale::absolute;
  std::uint64_t at_most = 0;  ///< trials, >= 1
  Family family;
};

/// Determines at which numbers of trials to look and, from the counts there, whether the interval of every category, or
/// that of one, is as narrow as wanted. The intervals are confidence sequences: all of them cover at once, at all n at
/// once, with the confidence of the family. They therefore remain valid if sampling stops because of them, whichever of
/// them the decision uses.
///
/// A pure function of goal and counts, with the same bits on every machine: where a run stops does not depend on
/// threads, compilers or libraries.
class StoppingRule {
 public:
  explicit StoppingRule(const StoppingGoal& goal);

  /// The next number of trials at which to look, after `trials` of them: 50, 60, ..., 100, then 10 % more each time, in
  /// whole tens, at most `at_most`. It depends on the number of trials only, so that a resumed run looks at the same
  /// numbers as an uninterrupted one. A look comes at most 10 % late (at 50, 20 %). The intervals are valid for any
  /// schedule.
  [[nodiscard]] std::uint64_t next_look(std::uint64_t trials) const;

  /// Whether all intervals have the wanted half-width: those of the prespecified categories, of the others that
  /// occurred, and of any category that has not occurred.
  [[nodiscard]] bool narrow_enough(const CategoryCounts& counts) const;

  /// Whether one interval, that of these counts, has the wanted half-width.
  [[nodiscard]] bool narrow_enough(const Proportion& counts, const Interval& interval) const;

  /// The intervals that the rule uses; these are the ones to report.
  [[nodiscard]] Interval interval_of_prespecified(const Proportion& counts) const;
  [[nodiscard]] Interval interval_of_others(const Proportion& counts) const;

 private:
  StoppingGoal goal_;
  ConfidenceSequence sequence_;
};

}  // namespace rocking::stats
