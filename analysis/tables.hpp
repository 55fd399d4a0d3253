#pragma once

#include <map>
#include <set>
#include <string>

#include "rocking/output/report.hpp"

/// The numbers of a report as tables for other programs and for publications.
namespace rocking::analysis {

/// CSV (RFC 4180) with a line for each condition and each response mode that any condition lists: the parameters, the
/// shaking, `n`, `mode`, `count`, `estimate`, `low`, `high` (the interval shown in figures). Numbers with all their
/// digits. `low` and `high` are empty where nothing is random, and where the report contains no interval of a mode that
/// did not occur.
[[nodiscard]] std::string modes_csv(const Report& report);

/// CSV with a line for each condition: the parameters, the shaking, `n`, `differ` with `low` and `high`, `entropy_nat`,
/// `pairs`, `diverged`, `lower_quartile`, `median`, `upper_quartile` [periods]. A field is empty if there is no value.
[[nodiscard]] std::string non_recurrence_csv(const Report& report);

/// CSV with a line for each condition, quantity and level: the parameters, `n`, `quantity`, `unit`, `of`, `beyond`,
/// `level`, `value`, `low`, `high`. A field is empty if there is no value.
[[nodiscard]] std::string quantiles_csv(const Report& report);

/// A LaTeX table (booktabs) with a line for each condition: n, then for each of the five most frequent modes
/// (overturning among them if it occurs) the per cent with the interval, or the upper end of the interval of a mode
/// that did not occur.
[[nodiscard]] std::string modes_latex(const Report& report);

/// The tables of a report in the formats `csv` and `latex`, as far as they are asked for: text by the name of the file.
[[nodiscard]] std::map<std::string, std::string> table_files(const Report& report,
                                                             const std::set<std::string>& formats);

// Which response, and by when, as tables for other programs and for publications. Empty unless the run has
// `until_classified`.

/// CSV with a line for each condition: the parameters, the shaking, `n`, `unresolved_at_horizon`, `not_classified`, the
/// quartiles of the settling period and the period by which all but one per cent have settled with their intervals,
/// `differ` at the fixed horizon and in the end. A field is empty if there is no value.
[[nodiscard]] std::string settling_csv(const Report& report);

/// CSV with a line for each condition, response mode and period at which its cumulative incidence changes: the
/// parameters, the shaking, `n`, `mode`, `period`, `estimate`, `low`, `high`, `band_low`, `band_high`. The mode `any` is
/// that of having settled; `diverged` the divergence of pairs.
[[nodiscard]] std::string incidence_csv(const Report& report);

/// CSV with a line for each condition and watched response mode: the parameters, the shaking, `n`, `mode`, `left`,
/// `watched_periods`, `per_1000_periods`, `low`, `high`.
[[nodiscard]] std::string leaving_csv(const Report& report);

/// CSV with a line for each condition and response mode of its long runs: the parameters, the shaking, `n`, `mode`,
/// `long_runs`, `windows` of each, `share`, `low`, `high`. Empty without long runs.
[[nodiscard]] std::string long_run_csv(const Report& report);

/// A LaTeX table (booktabs) of the long-run shares of time, with a line for each condition. Empty without long runs.
[[nodiscard]] std::string long_run_latex(const Report& report);

/// A LaTeX table (booktabs) with a line for each condition: the realisations that are unresolved at the fixed horizon
/// and in the end, the median settling period, and the probability that two runs differ at both.
[[nodiscard]] std::string settling_latex(const Report& report);

}  // namespace rocking::analysis
