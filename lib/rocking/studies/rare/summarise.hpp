#pragma once

#include "rocking/studies/rare/question.hpp"

namespace rocking {

/// The probability of the event under a record of a suite of ground motions, each of which is equally likely.
struct RareSuite {
  std::vector<Parameter> parameters;  ///< the rest of the sweep
  std::size_t records = 0;
  std::optional<double> probability;     ///< mean over the records; absent if that of one is
  std::optional<double> relative_error;  ///< standard error over the probability; absent if that of all records is
  stats::Interval interval;              ///< for these records: they are not taken as a sample of others
  double confidence = 0.95;
};

/// One for each combination of the other swept values under which there are several records. `estimates`: of the
/// conditions. The sampling is stratified by records; one whose error is not known, as with the probability 0, has the
/// ends of its own interval.
[[nodiscard]] std::vector<RareSuite> rare_suites(const std::vector<Condition>& conditions,
                                                 const std::vector<RareEstimate>& estimates);

}  // namespace rocking

namespace rocking::rare {

/// Fewer repetitions have the interval [0, 1]: one from fewer has not been tested. So many are made before the share of a
/// condition in the time counts.
inline constexpr std::size_t least_with_interval = 8;

/// Sets what follows from the repetitions: the probability, its error and interval, and the work. `confidence` in (0, 1);
/// `particles`: of a repetition.
void summarise_repetitions(RareEstimate& estimate, double confidence, std::uint64_t particles);

}  // namespace rocking::rare
