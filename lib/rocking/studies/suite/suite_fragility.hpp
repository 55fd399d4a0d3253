#pragma once

#include <cstdint>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {

/// Bootstrap samples of the records of a suite, and of the test of its law.
inline constexpr std::uint64_t suite_samples = 499;

/// The curve of a group that is a suite. `seed`: of the bootstraps.
[[nodiscard]] SuiteCurve suite_curve(const StripeGroup& group, const FragilityEvent& event, std::uint64_t seed,
                                     const base::ManyParts& how = {});

/// Its parts, at most: bootstrap samples, parameters, records and measures of intensity.
[[nodiscard]] std::uint64_t parts_of_suite_curve(const StripeGroup& group);

/// The measures by growing dispersion of the law of the suite; of equal ones the one with the smaller deviance first.
/// Without measures: empty. A measure is a part.
[[nodiscard]] std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes,
                                                         const FragilityEvent& event, const base::ManyParts& how = {});

}  // namespace rocking
