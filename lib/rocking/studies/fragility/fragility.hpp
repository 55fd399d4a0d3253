#pragma once

#include <variant>

#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/studies/fragility/fragility_curve.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

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

/// Compares the rates of two suites of the same records, sample by sample of their bootstraps, which draw the same records:
/// with common random numbers the difference is known better than either rate. By the law only where both have one.
[[nodiscard]] RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard,
                                            RateBasis basis = RateBasis::law_if_fitted);

/// The surface over two different measures, of surface_measure_names, with the bootstrap samples of the records that the
/// curve of the same group has. Throws base::InputError if a measure is not known of a motion.
[[nodiscard]] FragilitySurface fragility_surface(const StripeGroup& group, const SuiteCurve& curve,
                                                 const std::vector<std::string>& measures,
                                                 const std::optional<JointHazard>& hazard = std::nullopt,
                                                 const base::ManyParts& how = {});

/// The curves of a run from its stripes: for each group, for each event. Throws base::InputError if the hazard curve is one
/// of another intensity, and base::Stopped if
/// it is asked to stop. Uses `threads`, `stop_requested` and `on_progress` of
/// the options; progress counts parts of about equal work, most of them bootstrap samples.
[[nodiscard]] RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& groups,
                                         const FragilityQuestion& question, const RunOptions& options);

/// The probabilities of an event with this rate within each of these times.
[[nodiscard]] std::vector<RateInYears> in_years(const AnnualRate& rate, const std::vector<double>& years);

/// Throws base::InputError where the hazard curve is one of another intensity than that of the run, or of one period where
/// its sweep has several.
void check_hazard(const HazardCurve& hazard, const Experiment& experiment);

/// A block of a run: its curve of the event, and the stripes from which it follows.
struct BlockCurve {
  std::string name;
  std::variant<const FragilityCurve*, const SuiteCurve*> curve;
  const StripeGroup* group;
};

/// Whether the blocks still stand after `years` [years], > 0, under each of the hazard curves, at least one. Several blocks
/// must have the same levels of the same motions. `seed`: of the bootstraps of all together. Throws base::InputError.
[[nodiscard]] Survival survival(const std::vector<BlockCurve>& blocks, double years,
                                const std::vector<HazardCurve>& hazards, std::uint64_t seed,
                                const base::ManyParts& how = {});

/// Levels of each record. `measure`: in place of the swept intensity.
[[nodiscard]] stats::SuiteLevels levels_of_records(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                                   std::optional<IntensityMeasure> measure = std::nullopt);

/// The measures by growing dispersion of the law of the suite; of equal ones the one with the smaller deviance first.
/// Without measures: empty. A measure is a part.
[[nodiscard]] std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                                         const base::ManyParts& how = {});

/// Of the text of a file with this name; otherwise as those of question.hpp.
[[nodiscard]] std::vector<RareOfCurve> rare_levels(const std::string& text, const std::string& name,
                                                   const Experiment& experiment);

/// The place of an estimate of a probability that one before it has estimated too: a curve would join them. Absent if there
/// is none.
[[nodiscard]] std::optional<std::size_t> second_estimate(const std::vector<RareOfCurve>& rare);

/// Place of the ground motion in a sweep of records.
inline constexpr std::string_view record_pointer = "/excitation/file";
/// The name of the ground motion of a scene; empty: it has none.
[[nodiscard]] std::string record_of(const Scene& scene);

[[nodiscard]] bool have_equal_values(const std::vector<Parameter>& a, const std::vector<Parameter>& b);

}  // namespace rocking
