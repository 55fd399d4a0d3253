#pragma once

#include <optional>
#include <vector>

#include "rocking/studies/run_fragility.hpp"

namespace rocking {

/// Compares the isotonic rates of two suites of the same records, sample by sample of their bootstraps, which draw the same
/// records: with common random numbers the difference is known better than either rate.
[[nodiscard]] RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option,
                                            const HazardCurve& hazard);

}  // namespace rocking
