#pragma once

#include <optional>
#include <vector>

#include "rocking/stats/fit_suite.hpp"

namespace rocking::stats {

/// The law of a suite with ln median = a + slope c, with the number c of each record, by maximum likelihood. The test
/// compares the root of twice the gain of ln likelihood with Student's distribution with (records - 2) degrees of freedom.
///
/// Absent with fewer than four records, where the numbers are equal, or without a law.
[[nodiscard]] std::optional<SuiteCovariate> suite_covariate(const SuiteLevels& suite,
                                                            const std::vector<double>& numbers);

}  // namespace rocking::stats
