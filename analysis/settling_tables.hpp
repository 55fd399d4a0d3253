#pragma once

#include <string>

#include "rocking/output/report.hpp"

/// Which response, and by when, as tables for other programs and for publications. Empty unless the run has
/// `until_classified`.
namespace rocking::analysis {

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
