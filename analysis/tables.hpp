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

}  // namespace rocking::analysis
