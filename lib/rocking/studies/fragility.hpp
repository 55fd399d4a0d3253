#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/stats/lack_of_fit.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// The fitted function at one intensity.
struct FittedProbability {
  double value = 0.0;
  stats::Interval band;    ///< its interval at this intensity alone
  bool is_missed = false;  ///< the value lies outside FragilityLevel::simultaneous
};

/// Overturning at one intensity.
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
  double confidence = 0.95;            ///< that the experiment asks for
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
/// decrease. The bootstrap numbers are a function of `seed`.
[[nodiscard]] FragilityCurve fragility_curve(const std::vector<stats::IntensityLevel>& levels, double confidence,
                                             std::uint64_t seed);

/// JSON pointer to the intensity that an experiment sweeps: `/excitation/amplitude`, `/excitation/amplitude_g`,
/// `/excitation/amplitude_m_s2`, `/excitation/scale`, `pga_g` or `pgv_m_s`; empty where it sweeps none of them.
[[nodiscard]] std::string_view intensity_of(const Experiment& experiment);

/// A curve for each point of the grid of the other entries. An intensity of 0 has no logarithm and is left out. The
/// experiment must sweep an intensity and fix the number of realisations (no `until`). Throws InputError where the run
/// is not finished.
[[nodiscard]] std::vector<FragilityCurve> fragility(const Experiment& experiment, const Store& store);

}  // namespace rocking
