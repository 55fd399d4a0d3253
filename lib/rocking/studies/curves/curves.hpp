#pragma once

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/studies/curves/fragility_curve.hpp"

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
[[nodiscard]] FragilityCurve fragility(const StripeGroup& group, const ResponseEvent& event, std::uint64_t seed,
                                       const base::ManyParts& how = {});

/// Bootstrap samples of the records of a suite, and of the test of its law.
inline constexpr std::uint64_t suite_samples = 499;

/// The curve of a group that is a suite. `seed`: of the bootstraps.
[[nodiscard]] SuiteCurve suite_curve(const StripeGroup& group, const ResponseEvent& event, std::uint64_t seed,
                                     const base::ManyParts& how = {});

/// Its parts, at most: bootstrap samples, parameters, records and measures of intensity.
[[nodiscard]] std::uint64_t parts_of_suite_curve(const StripeGroup& group);

/// Levels of each record. `measure`: in place of the swept intensity.
[[nodiscard]] stats::SuiteLevels levels_of_records(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                                   std::optional<IntensityMeasure> measure = std::nullopt);

/// The measures by growing dispersion of the law of the suite; of equal ones the one with the smaller deviance first.
/// Without measures: empty. A measure is a part.
[[nodiscard]] std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                                         const base::ManyParts& how = {});

/// Place of the ground motion in a sweep of records.
inline constexpr std::string_view record_pointer = "/excitation/file";
/// The name of the ground motion of a scene; empty: it has none.
[[nodiscard]] std::string record_of(const Scene& scene);

[[nodiscard]] bool have_equal_values(const std::vector<Parameter>& a, const std::vector<Parameter>& b);

}  // namespace rocking
