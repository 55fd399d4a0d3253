#pragma once

#include "rocking/output/report.hpp"
#include "rocking/scene/number_rule.hpp"

namespace rocking {

/// Reports where the numbers of a report contradict each other: counts that do not add up to the number of
/// realisations, an estimate that is not count/n, parts that are larger than the whole.
void check_reported_counts(const Report& report, Problems& problems);

}  // namespace rocking
