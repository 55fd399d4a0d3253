#pragma once

#include <cstdint>

#include "rocking/stats/confidence_sequence.hpp"
#include "rocking/stats/family.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// When to stop sampling: what is wanted, and what may be spent on it.
struct StoppingGoal {
  double half_width = 0.0;    ///< that every interval of the family is to reach, in (0, 1/2)
  std::uint64_t at_most = 0;  ///< trials; at least 1
  Family family;
};

/// Says at which numbers of trials to look and, from the counts there, whether every category's interval is as narrow
/// as wanted. The intervals are confidence sequences: all of them cover at once, at all n at once, with the family's
/// confidence, so that stopping because of them leaves them as good as they were.
///
/// A pure function of goal and counts, the same to the bit on every machine: where a run stops cannot depend on
/// threads, compilers or libraries.
class StoppingRule {
 public:
  explicit StoppingRule(const StoppingGoal& goal);

  /// The next number of trials at which to look, after `trials` of them: 50, 60, ..., 100, then a tenth more each time,
  /// in whole tens; `at_most` ends it. Only the number of trials decides, so that a resumed run looks where an
  /// uninterrupted one does. A look comes at most 10 % late (at 50, 20 %); validity does not depend on the schedule.
  [[nodiscard]] std::uint64_t next_look(std::uint64_t trials) const;

  /// Whether all intervals have the half-width asked for: of the categories foreseen, of those that occurred besides,
  /// and of any that has not occurred.
  [[nodiscard]] bool narrow_enough(const CategoryCounts& counts) const;

  /// The intervals by which it decides, and which to report.
  [[nodiscard]] Interval interval_of_foreseen(const Proportion& counts) const;
  [[nodiscard]] Interval interval_of_unforeseen(const Proportion& counts) const;

 private:
  StoppingGoal goal_;
  ConfidenceSequence sequence_;
};

}  // namespace rocking::stats
