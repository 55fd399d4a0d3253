#pragma once

#include <cstdint>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

namespace rocking {

/// Bootstrap samples of the records of a suite, and of the test of its law.
inline constexpr std::uint64_t suite_samples = 499;

/// The curve of a group that is a suite. `seed`: of the bootstraps. `metadata`: of its records, in any order; empty: none.
[[nodiscard]] SuiteCurve suite_curve(const StripeGroup& group, const FragilityEvent& event, std::uint64_t seed,
                                     const std::vector<RecordMetadata>& metadata = {}, const base::ManyParts& how = {});

/// Its parts, at most: bootstrap samples, parameters, records and measures of intensity.
[[nodiscard]] std::uint64_t parts_of_suite_curve(const StripeGroup& group);

}  // namespace rocking
