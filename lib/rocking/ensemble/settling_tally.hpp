#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/response_times.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/mean_share.hpp"
#include "rocking/stats/quantile_interval.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// How often settled responses of one mode were left while they were watched.
struct Leaving {
  std::uint64_t watched_periods = 0;  ///< of all of them, from the end of the last held window until they were left
  std::uint64_t left = 0;
  stats::Interval per_1000_periods;  ///< exact interval of the rate, if it is constant
};

/// Upper end of the exact interval of the rate of leaving, per 1000 periods, where nothing was left in so many > 0 periods.
[[nodiscard]] double bound_of_none_left(std::uint64_t watched_periods, double confidence);

/// Windows of the long runs of a condition.
struct LongRuns {
  std::uint64_t windows = 0;  ///< counted in each of them
  std::uint64_t count = 0;    ///< number of long runs
  struct Share {
    double share = 0.0;  ///< of these windows
    stats::Interval interval;
  };
  std::map<section::ResponseMode, Share> shares;
};

/// Periods from the settling period, the end of the first held window, to the end of the last one.
[[nodiscard]] std::int64_t confirmation_periods(const Horizon& horizon);

/// Which response, and by when, of the realisations of a condition with UntilClassified.
struct SettlingResult {
  static constexpr std::size_t most_times = 200;

  ModeTally at_horizon;          ///< modes at the fixed horizon
  std::optional<double> differ;  ///< probability that two runs differ there; absent for fewer than two
  std::optional<stats::Interval> differ_interval;  ///< Clopper-Pearson on disjoint pairs; likewise
  std::uint64_t censored = 0;                      ///< realisations that were not classified
  /// By mode, thinned to `most_times` times.
  std::map<section::ResponseMode, std::vector<stats::Incidence>> incidence;
  std::map<section::ResponseMode, Leaving> leaving;  ///< empty unless settled responses are watched
  std::vector<stats::Incidence> divergence;          ///< of pairs, censored at the fixed horizon
  std::optional<LongRuns> long_runs;                 ///< absent unless asked for
  ResponseTimes times;
};

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

}  // namespace rocking
