#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/section/response_mode.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile.hpp"

/// Which response the realisations of a condition with UntilClassified have come to, and by when.
namespace rocking {

/// Number of realisations of a condition, by response mode.
using ModeTally = std::map<section::ResponseMode, std::uint64_t>;

/// When the realisations of a condition with UntilClassified have settled, in whatever mode, and when pairs diverged.
struct ResponseTimes {
  static constexpr std::size_t most_times = 200;
  static constexpr double tolerable_share = 0.01;  ///< of unsettled realisations

  std::vector<stats::Incidence> any_mode;          ///< probability of having settled, thinned to `most_times` times
  std::vector<stats::QuantileEstimate> quartiles;  ///< of the settling period
  stats::TimeToShare nearly_all;                   ///< by which period all but `tolerable_share` have settled
  std::vector<stats::QuantileEstimate> divergence_quartiles;  ///< of the divergence time of pairs
};

/// How often settled responses of one mode were left while they were watched.
struct Leaving {
  std::uint64_t watched_periods = 0;  ///< of all of them, from the end of the last held window until they were left
  std::uint64_t left = 0;
  stats::Interval per_1000_periods;  ///< exact interval of the rate, if it is constant
};

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

}  // namespace rocking
