#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/quantile_interval.hpp"
#include "rocking/stats/survival.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// When the realisations of a condition with UntilClassified have settled, in whatever mode, and when pairs diverged.
struct ResponseTimes {
  static constexpr std::size_t most_times = 200;
  static constexpr double tolerable_share = 0.01;  ///< of unsettled realisations

  std::vector<stats::Incidence> any_mode;          ///< probability of having settled, thinned to `most_times` times
  std::vector<stats::QuantileEstimate> quartiles;  ///< of the settling period
  stats::TimeToShare nearly_all;                   ///< by which period all but `tolerable_share` have settled
  std::vector<stats::QuantileEstimate> divergence_quartiles;  ///< of the divergence time of pairs
};

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
