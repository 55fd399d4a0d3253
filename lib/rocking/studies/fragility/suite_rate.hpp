#pragma once

#include <optional>
#include <vector>

#include "rocking/studies/fragility/run_fragility.hpp"

namespace rocking {

/// Compares the rates of two suites of the same records, sample by sample of their bootstraps, which draw the same records:
/// with common random numbers the difference is known better than either rate. By the law only where both have one.
[[nodiscard]] RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard,
                                            RateBasis basis = RateBasis::law_if_fitted);

}  // namespace rocking
