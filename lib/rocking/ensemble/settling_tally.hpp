#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "rocking/ensemble/result.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/mean_share.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Upper end of the exact interval of the rate of leaving, per 1000 periods, where nothing was left in so many > 0 periods.
[[nodiscard]] double bound_of_none_left(std::uint64_t watched_periods, double confidence);

/// Periods from the settling period, the end of the first held window, to the end of the last one.
[[nodiscard]] std::int64_t confirmation_periods(const Horizon& horizon);

/// Collects the settling of the realisations of a condition. Memory is proportional to the number of distinct periods.
class SettlingTally {
 public:
  /// Takes the next realisation, which has been observed until it was classified.
  void add(const Summary& summary);
  [[nodiscard]] bool is_empty() const { return ends_.empty(); }
  /// `diverged`: pairs by the period in which they diverged; `later`: those that had not diverged by the horizon.
  [[nodiscard]] SettlingResult result(const Condition& condition, const std::map<std::int64_t, std::uint64_t>& diverged,
                                      std::uint64_t later) const;

 private:
  [[nodiscard]] LongRuns long_runs(double confidence) const;

  struct End {
    std::int64_t period = 0;
    std::optional<section::ResponseMode> mode;  ///< absent: censored
    friend bool operator<(const End& a, const End& b) {
      return a.period != b.period ? a.period < b.period : a.mode < b.mode;
    }
  };

  /// Settled responses of one mode.
  struct Settled {
    std::uint64_t realisations = 0;
    std::uint64_t periods = 0;  ///< of all of them, from the settling period on
    std::uint64_t left = 0;
  };

  std::map<End, std::uint64_t> ends_;
  ModeTally at_horizon_;
  std::map<section::ResponseMode, Settled> settled_;
  std::uint64_t long_runs_ = 0;
  std::uint64_t long_run_windows_ = 0;  ///< of each of them
  std::map<section::ResponseMode, stats::ClusteredProportion> in_long_runs_;
  std::optional<section::ResponseMode> first_of_pair_;
  stats::Proportion differing_pairs_;
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
