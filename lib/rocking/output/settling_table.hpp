#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/report.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking {

/// Share of a condition's realisations above which its unresolved responses call for a longer horizon.
inline constexpr double worrying_unresolved_share = 0.05;

/// A response mode that was left again while it was watched.
struct LeftMode {
  section::ResponseMode mode;
  std::uint64_t left = 0;
  std::uint64_t watched_periods = 0;
  stats::Interval per_1000_periods;
};

/// Windows of the long runs of a condition that have one response mode.
struct LongRunShare {
  section::ResponseMode mode;
  double share = 0.0;
  stats::Interval interval;  ///< for this mode alone
};

/// Long-run shares of time of a condition.
struct LongRunRow {
  std::uint64_t realisations = 0;    ///< with a long run
  std::uint64_t windows = 0;         ///< counted in each of them
  std::vector<LongRunShare> shares;  ///< of each mode that has any
};

/// A condition of a run with UntilClassified: a row of the table.
struct SettlingRow {
  std::vector<Parameter> parameters;  ///< swept; the same pointers in every row
  std::uint64_t realisations = 0;
  double confidence = 0.95;
  std::uint64_t unresolved_at_horizon = 0;
  std::uint64_t censored = 0;                 ///< not classified at the limit
  std::optional<std::int64_t> fixed_horizon;  ///< [periods]; absent if it is not known
  std::optional<std::int64_t> limit;          ///< at_most_periods
  std::int64_t confirmation = 0;              ///< periods of the held windows after the first
  stats::QuantileEstimate median;             ///< settling period
  stats::TimeToShare all_but_one_per_cent;
  std::optional<double> differ_at_horizon, differ_in_the_end;
  std::vector<LeftMode> leaving;  ///< of each mode that was watched
  int held_windows = 1;
  std::optional<LongRunRow> long_runs;  ///< absent unless asked for
};

/// The row of a condition; absent without UntilClassified.
[[nodiscard]] std::optional<SettlingRow> settling_row(const ReportedCondition& condition);

/// The rows of a run with UntilClassified; none of another run.
[[nodiscard]] std::vector<SettlingRow> settling_rows(const Report& report);

/// `140 [80, 200]`; `> 1000` where the median lies beyond the observation, with the end of its interval that is known.
[[nodiscard]] look::Cell period_cell(const stats::QuantileEstimate& quantile, const std::optional<std::int64_t>& limit);

/// By when all but one per cent have settled: `320 [260, -]`, `about 4100 [2480, 7760]` if it is extrapolated, `unknown`.
[[nodiscard]] std::string horizon_text(const stats::TimeToShare& found);

/// `0.31 [0.01, 1.72]`, left per 1000 watched periods with its exact interval.
[[nodiscard]] std::string leaving_text(const LeftMode& leaving);

/// Where no settled response was left: the watched periods of all conditions together, of which there is at least one,
/// the upper bound of the rate over them, and what the watch does not see.
[[nodiscard]] std::string none_left_text(std::span<const SettlingRow> conditions);

/// What qualifies "in the end" if a response was held for one window only; empty if all were held for more.
[[nodiscard]] std::string end_proviso(std::span<const SettlingRow> conditions);

/// Whether an interval of a rate of leaving exceeds one per 1000 periods. Then the label is that of a window.
[[nodiscard]] bool may_be_left(const LeftMode& leaving);

/// Text for a terminal, after the table of the response modes: that its shares are those in the end; how many
/// realisations were not classified; for each condition the unresolved ones at the fixed horizon and in the end, the
/// settling period, and the probability that two runs differ at both; rates of leaving; which limit would do where it
/// was too short. Columns for which `width` has no room are omitted. Empty without rows.
[[nodiscard]] std::string settling_text(std::span<const SettlingRow> conditions, std::size_t width);

/// What to do about a fixed horizon at which more than worrying_unresolved_share of a condition is unresolved: a
/// sentence with `until_classified` and a limit. Empty if the share is smaller, if the run has UntilClassified, or if its
/// excitation has no periods.
[[nodiscard]] std::string unresolved_remedy(const Report& report);

/// What to do about a limit at which more than one per cent of a condition is not classified: the limit that would do,
/// or that it cannot be told; empty if it is less. `name`: of the condition, empty if there is one only.
[[nodiscard]] std::string limit_remedy(const SettlingRow& condition, const std::string& name);

}  // namespace rocking
