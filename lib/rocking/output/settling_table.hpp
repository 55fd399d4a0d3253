#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "rocking/output/condition_table.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/quantile.hpp"

namespace rocking {

/// Share of a condition's realisations above which its unresolved responses call for a longer horizon.
inline constexpr double worrying_unresolved_share = 0.05;

/// Of a condition with UntilClassified: the realisations that were unresolved at its fixed horizon.
[[nodiscard]] std::uint64_t unresolved_at_horizon(const ReportedCondition& condition);
/// Periods of the fixed horizon; absent if they are not known.
[[nodiscard]] std::optional<std::int64_t> fixed_horizon(const ReportedCondition& condition);
/// UntilClassified::at_most_periods.
[[nodiscard]] std::optional<std::int64_t> limit_of(const ReportedCondition& condition);

/// That of all conditions; empty if they differ.
[[nodiscard]] std::string common_limit(const Report& report);

/// `140 [80, 200]`; `> 1000` where the median lies beyond the observation, with the end of its interval that is known.
[[nodiscard]] look::Cell period_cell(const stats::QuantileEstimate& quantile, const std::optional<std::int64_t>& limit);

/// By when all but one per cent have settled: `320 [260, -]`, `about 4100 [2480, 7760]` if it is extrapolated, `unknown`.
[[nodiscard]] std::string horizon_text(const stats::TimeToShare& found);

/// How often settled responses were left while they were watched: that none was, in how many periods, with the upper
/// bound of the rate over all of them and what the watch does not see; or how often, and which mode of which condition is
/// left most often. Empty where none was watched.
[[nodiscard]] std::string leaving_text(const Report& report);

/// What qualifies "in the end" if a response was held for one window only; empty if all were held for more.
[[nodiscard]] std::string end_proviso(const Report& report);

/// By when responses have settled, and how often two runs differ: a row for each condition with UntilClassified.
[[nodiscard]] RunTable settling_table(const Report& report);

/// How often settled responses were left: a row for each condition and mode that was watched.
[[nodiscard]] RunTable leaving_table(const Report& report);

/// Text for a terminal, after the table of the response modes: that its shares are those in the end; how many
/// realisations were not classified; for each condition the unresolved ones at the fixed horizon and in the end, the
/// settling period, and the probability that two runs differ at both; rates of leaving; which limit would do where it
/// was too short. Columns for which `width` has no room are omitted. Empty without UntilClassified.
[[nodiscard]] std::string settling_text(const Report& report, std::size_t width);

/// What to do about a fixed horizon at which more than worrying_unresolved_share of a condition is unresolved: a
/// sentence with `until_classified` and a limit. Empty if the share is smaller, if the run has UntilClassified, or if its
/// excitation has no periods.
[[nodiscard]] std::string unresolved_remedy(const Report& report);

/// What to do about a limit at which more than one per cent of a condition is not classified: the limit that would do,
/// or that it cannot be told; empty if it is less. `name`: of the condition, empty if there is one only.
[[nodiscard]] std::string limit_remedy(const ReportedCondition& condition, const std::string& name);

// Long-run shares of time: of the windows of the realisations with a long run (`long_run_every`), by response mode.

/// For publications: a row for each condition with long runs, a column for each of the most frequent modes in per cent,
/// `64.0 [52.1, 74.8]`; `< 7.0`, an upper bound, of a mode that no window has.
[[nodiscard]] RunTable long_run_table(const Report& report);
/// For CSV: a row for each condition and response mode of its long runs.
[[nodiscard]] RunTable long_run_share_table(const Report& report);

/// Text for a terminal: a table of the conditions in which more than one mode occurs, with lines up to `width`, and
/// the number of the others. Empty without long runs.
[[nodiscard]] std::string long_run_text(const Report& report, std::size_t width);

}  // namespace rocking
