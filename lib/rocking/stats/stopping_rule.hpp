#pragma once

#include <cstdint>

#include "rocking/stats/confidence_sequence.hpp"
#include "rocking/stats/family.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Goal of a stopping rule: the wanted precision and the largest number of trials.
struct StoppingGoal {
  double half_width = 0.0;    ///< wanted for every interval of the family, in (0, 1/2)
  std::uint64_t at_most = 0;  ///< trials, >= 1
  Family family;
};

/// Determines at which numbers of trials to look and, from the counts there, whether the interval of every category is
/// as narrow as wanted. The intervals are confidence sequences: all of them cover at once, at all n at once, with the
/// confidence of the family. They therefore remain valid if sampling stops because of them.
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

  /// The intervals that the rule uses; these are the ones to report.
  [[nodiscard]] Interval interval_of_prespecified(const Proportion& counts) const;
  [[nodiscard]] Interval interval_of_others(const Proportion& counts) const;

 private:
  StoppingGoal goal_;
  ConfidenceSequence sequence_;
};

}  // namespace rocking::stats
