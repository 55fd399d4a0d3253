#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"
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
