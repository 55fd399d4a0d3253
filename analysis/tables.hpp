#pragma once

#include <string>

#include "analysis/run_report.hpp"

/// The numbers of a report as tables for other programs and for papers.
namespace rocking::analysis {

/// CSV (RFC 4180): a line for each condition and response mode that it lists: the parameters, `n`, `mode`, `count`,
/// `estimate`, `low`, `high` (the interval that figures show). Numbers in full.
[[nodiscard]] std::string modes_csv(const RunReport& report);

/// CSV: a line for each condition: the parameters, `n`, `differ` with `low` and `high`, `entropy_nat`, `pairs`, `parted`,
/// `lower_quartile`, `median`, `upper_quartile` [periods]. Empty fields where there is no value.
[[nodiscard]] std::string non_recurrence_csv(const RunReport& report);

/// A LaTeX table (booktabs): a line for each condition, a column for each of the five most frequent modes: per cent, with
/// its interval; n before them.
[[nodiscard]] std::string modes_latex(const RunReport& report);

}  // namespace rocking::analysis
