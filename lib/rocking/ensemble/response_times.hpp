#pragma once

#include <cstdint>
#include <map>

#include "rocking/ensemble/settling.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Upper bound of the share of realisations with a property that none of so many had: the upper end of the interval of
/// Clopper and Pearson.
[[nodiscard]] double bound_of_none(std::uint64_t realisations, double confidence);

/// Collects the settling periods of the realisations of a condition. Memory is proportional to the number of distinct
/// periods.
class ResponseTimesTally {
 public:
  void add(const Summary& summary);
  /// `diverged`: pairs by the period in which they diverged; `later`: those that had not diverged by the horizon.
  [[nodiscard]] ResponseTimes result(const Condition& condition, const std::map<std::int64_t, std::uint64_t>& diverged,
                                     std::uint64_t later) const;

 private:
  std::map<std::int64_t, std::uint64_t> settled_;   ///< realisations by settling period
  std::map<std::int64_t, std::uint64_t> censored_;  ///< the others, by the period at which their observation ended
};

}  // namespace rocking
