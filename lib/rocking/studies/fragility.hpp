#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/stats/lack_of_fit.hpp"
#include "rocking/studies/suite/stripes.hpp"

namespace rocking {

/// The fitted function at one intensity.
struct FittedProbability {
  double value = 0.0;
  stats::Interval band;    ///< its interval at this intensity alone
  bool is_missed = false;  ///< the value lies outside FragilityLevel::simultaneous
};

/// The event at one intensity: overturning, or the event of the curve.
struct FragilityLevel {
  double intensity = 0.0;
  stats::Proportion overturned;
  double estimate = 0.0;                    ///< share of the realisations that overturned
  stats::Interval exact;                    ///< Clopper-Pearson, of this level alone
  stats::Interval simultaneous;             ///< Bonferroni-Clopper-Pearson over the levels of the curve
  std::optional<FittedProbability> fitted;  ///< absent where no function is fitted
  /// Most likely probability that does not decrease with the intensity; present where the fitted function was rejected.
  /// Its band is `simultaneous`, which holds also if the probability decreases somewhere.
  std::optional<double> isotonic;
};

/// Probability of overturning as a function of intensity, from conditions that differ in nothing else.
struct FragilityCurve {
  std::string parameter;               ///< JSON pointer to the intensity
  std::vector<Parameter> others;       ///< the rest of the sweep
  FragilityEvent event;                ///< what is counted as overturned
  double confidence = 0.95;            ///< that the experiment asks for
  std::optional<double> least_uplift;  ///< of the group (StripeGroup); not of the curve of one record
  std::vector<FragilityLevel> levels;  ///< by growing intensity
  stats::FragilityFit fit;
  std::optional<stats::LackOfFit> test;  ///< of the fitted function; absent where none could be fitted

  /// Levels at which the fitted function lies outside the simultaneous interval.
  [[nodiscard]] std::size_t missed_levels() const;
  /// Whether this intensity lies outside the levels.
  [[nodiscard]] bool is_extrapolated(double intensity) const;
};

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
