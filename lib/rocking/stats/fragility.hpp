#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// What happened at one intensity of shaking: happened[j] is trial j's. Trials of one number at several intensities share
/// their draws, so they are no independent trials; those of different numbers are.
struct IntensityLevel {
  double intensity = 0.0;      ///< positive
  std::vector<bool> happened;  ///< may be shorter at one intensity than at another
};

/// How often it happened there.
[[nodiscard]] Proportion proportion_at(const IntensityLevel& level);

/// Why there is a fit, or none.
enum class FragilityOutcome : std::uint8_t {
  fitted,
  never_happened,   ///< at no intensity: nothing but that the median lies higher
  always_happened,  ///< at every intensity: it lies lower
  separated,      ///< never below some intensity, always above: the dispersion may be 0, the likelihood has no maximum
  does_not_rise,  ///< more frequent with the intensity by less than two standard errors, or at a dispersion above 10
  no_scatter,  ///< trials of different numbers differ in one way at most: nothing to estimate the covariance of two numbers from
  too_little,  ///< fewer than two intensities, or no more than one trial at each
};

/// A number with an interval for it.
struct Bounded {
  double value = 0.0;
  Interval interval;
};

/// P(happens at intensity x) = Phi((ln x - ln median)/dispersion): the capacity of what is shaken is lognormal.
///
/// Fitted by the largest likelihood of all trials, as a probit regression a + b u on u = ln x - `centre`. `covariance` of
/// (a, b) is the sandwich estimate over trial numbers: it counts trials that share their draws as the one piece of evidence
/// that they are, and does not rely on the law being true.
/// Source: Baker (2015), Earthquake Spectra 31, 579-599, for the likelihood; Liang & Zeger (1986), Biometrika 73, 13-22.
struct LognormalFragility {
  double centre = 0.0;
  double intercept = 0.0;  ///< a
  double slope = 0.0;      ///< b, positive
  struct {
    double aa = 0.0, ab = 0.0, bb = 0.0;
  } covariance;

  /// Probability at a positive intensity.
  [[nodiscard]] double probability(double intensity) const;
  /// Its interval at that intensity alone: Phi of a + b u -+ z standard errors (delta method).
  [[nodiscard]] Interval band(double intensity, double confidence) const;
  /// exp(centre - a/b), with the interval of its logarithm by the delta method.
  [[nodiscard]] Bounded median(double confidence) const;
  /// 1/b, the standard deviation of the capacity's logarithm; interval likewise.
  [[nodiscard]] Bounded dispersion(double confidence) const;
};

struct FragilityFit {
  FragilityOutcome outcome = FragilityOutcome::fitted;
  std::optional<LognormalFragility> law;  ///< where the outcome is `fitted`
};

/// Needs a level, and a trial at each. Newton's method on a concave likelihood; the maximum is to rounding.
[[nodiscard]] FragilityFit fit_lognormal(const std::vector<IntensityLevel>& levels);

}  // namespace rocking::stats
