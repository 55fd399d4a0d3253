#pragma once

#include <cstdint>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/fragility/fragility_curve.hpp"

namespace rocking {

/// Bootstrap samples of the test of the fitted function, and its significance level.
inline constexpr std::uint64_t fragility_samples = 999;
inline constexpr double fragility_significance = 0.05;

/// A curve with its estimates, intervals, fit and test; `levels` by growing intensity, at least one.
///
/// A function that the test rejects is not kept: the outcome is `rejected`, and the isotonic estimate takes its place;
/// or `not_monotone`, without an estimate, where the simultaneous intervals contradict every probability that does not
/// decrease. The bootstrap numbers are a function of `seed`; each of `fragility_samples` is a part.
[[nodiscard]] FragilityCurve fragility_curve(const std::vector<stats::IntensityLevel>& levels, double confidence,
                                             std::uint64_t seed, const base::ManyParts& how = {});

/// The curve of a group that is no suite. The experiment must fix the number of realisations (no `until`).
[[nodiscard]] FragilityCurve fragility(const StripeGroup& group, const FragilityEvent& event, std::uint64_t seed,
                                       const base::ManyParts& how = {});

}  // namespace rocking
