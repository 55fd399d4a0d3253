#pragma once

#include <optional>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

/// How far equal conditions fail to give equal responses. Absent where no condition has two realisations to compare.
namespace rocking::analysis {

/// `non_recurrence`: the probability that two runs differ in response mode, with its interval, against the swept parameter;
/// a curve for each set of the other parameters' values.
[[nodiscard]] std::optional<Figure> non_recurrence(const RunReport& report);

/// `parting_quartiles`: after how many periods two runs have parted, median and quartiles over pairs. A quartile beyond the
/// horizon is not drawn.
[[nodiscard]] std::optional<Figure> parting_quartiles(const RunReport& report);

}  // namespace rocking::analysis
