#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::analysis {

/// `parting_times`: the share of pairs of runs that have parted by each period, a curve for each condition that has
/// pairs; of more than seven conditions the seven in which two runs differ most often in response mode. From the
/// realisations, which a report does not hold. Absent where there are no pairs.
[[nodiscard]] std::optional<Figure> parting_times(const RunReport& report, const experiment::Store& store);

}  // namespace rocking::analysis
