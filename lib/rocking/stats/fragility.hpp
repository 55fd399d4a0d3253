#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Outcomes of the trials at one intensity: happened[j] is the outcome of trial j. Trials with the same number at
/// several intensities use common random numbers and are therefore dependent; trials with different numbers are
/// independent.
struct IntensityLevel {
  double intensity = 0.0;        ///< > 0
  std::vector<bool> happened;    ///< may have different lengths at different intensities
  std::uint64_t unresolved = 0;  ///< trials whose outcome is not known, and stands as not happened
};

/// Count of the trials at this level whose event happened.
[[nodiscard]] Proportion proportion_at(const IntensityLevel& level);

/// Number of trial numbers: the largest number of trials at a level.
[[nodiscard]] std::size_t trial_numbers(const std::vector<IntensityLevel>& levels);

/// Whether a fragility function could be fitted, and why not.
enum class FragilityOutcome : std::uint8_t {
  fitted,
  never_happened,   ///< at no intensity: only a lower bound of the median is known
  always_happened,  ///< at every intensity: only an upper bound of the median is known
  separated,  ///< never below some intensity, always above: the dispersion may be 0 and the likelihood has no maximum
  does_not_rise,  ///< the slope does not exceed 0 by the half-width of its interval, or the dispersion exceeds 10
  no_scatter,     ///< outcomes of different trial numbers vary in one way at most: the covariance would be singular
  too_little,     ///< fewer than two intensities, or at most one trial at each
  rejected,       ///< the test of fit rejects the lognormal law
  not_monotone,   ///< the shares contradict every probability that does not decrease with the intensity
  unresolved,     ///< the outcome of some trial is not known
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 10> fragility_outcome_names{
    "fitted",     "never_happened", "always_happened", "separated",    "does_not_rise",
    "no_scatter", "too_little",     "rejected",        "not_monotone", "unresolved"};
[[nodiscard]] constexpr std::string_view to_string(FragilityOutcome outcome) {
  return fragility_outcome_names[static_cast<std::size_t>(outcome)];
}

/// A value with its confidence interval.
struct Bounded {
  double value = 0.0;
  Interval interval;
};

/// P(event at intensity x) = Phi((ln x - ln median)/dispersion): the capacity is lognormal.
///
/// Maximum-likelihood fit to all trials, as a probit regression a + b u on u = ln x - `centre`. `covariance` of (a, b)
/// is the sandwich estimate over trial numbers. It treats trials with common random numbers as one cluster, and it
/// remains valid if the law is not exactly true. Source: Baker (2015), Earthquake Spectra 31, 579-599, for the
/// likelihood; Liang & Zeger (1986), Biometrika 73, 13-22.
struct LognormalFragility {
  double centre = 0.0;
  double intercept = 0.0;  ///< a [-]
  double slope = 0.0;      ///< b [-], > 0
  struct {
    double aa = 0.0, ab = 0.0, bb = 0.0;
  } covariance;
  /// Of Student's distribution, whose quantiles the intervals use: one less than the trial numbers whose outcomes
  /// differ from the most frequent ones, since only these inform on the covariance. Infinite: the normal distribution.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();

  /// Probability at an intensity > 0.
  [[nodiscard]] double probability(double intensity) const;
  /// Confidence interval of the probability at this intensity alone: Phi of a + b u -+ t standard errors (delta
  /// method).
  [[nodiscard]] Interval band(double intensity, double confidence) const;
  /// exp(centre - a/b). Its interval holds the intensities at which the band contains 1/2 (Fieller 1954, J. R. Stat.
  /// Soc. B 16, 175-185); it is [0, infinity] if the slope does not differ from 0 at this confidence.
  [[nodiscard]] Bounded median(double confidence) const;
  /// 1/b, the standard deviation of the logarithm of the capacity; its interval is that of its logarithm by the delta
  /// method.
  [[nodiscard]] Bounded dispersion(double confidence) const;
};

struct FragilityFit {
  FragilityOutcome outcome = FragilityOutcome::fitted;
  std::optional<LognormalFragility> law;  ///< present if and only if the outcome is `fitted`
};

/// Fits the law; its outcome is none of `rejected` and `not_monotone`. Needs at least one level, and at least one trial
/// at each. The slope must differ from 0 at this confidence, and at 95 %. Newton's method on a concave likelihood;
/// converges to rounding accuracy.
[[nodiscard]] FragilityFit fit_lognormal(const std::vector<IntensityLevel>& levels, double confidence = 0.95);

/// Test of the lognormal law against a probability of its own at each level.
struct LackOfFit {
  double deviance = 0.0;       ///< twice the difference of the log-likelihoods (probit_deviance)
  std::uint64_t samples = 0;   ///< bootstrap samples
  std::uint64_t as_large = 0;  ///< those whose deviance is at least as large
  double p_value = 1.0;        ///< (as_large + 1)/(samples + 1)
};

/// The lognormal law of a suite of records: the capacity of a trial is the product of two independent lognormal numbers,
/// one of its record and one of its own.
///
///     P(event at x | record) = Phi((ln x - ln median - z between_records)/within_record),   z ~ N(0, 1)
///     P(event at x)          = Phi((ln x - ln median)/dispersion),   dispersion^2 = between_records^2 + within_record^2
struct SuiteLaw {
  double median = 1.0;
  double between_records = 0.0;  ///< >= 0
  double within_record = 0.0;    ///< >= 0; exactly 0 where the outcomes of every record are a step
  double log_likelihood = 0.0;   ///< without binomial coefficients

  [[nodiscard]] double dispersion() const;
  /// For a record drawn at random.
  [[nodiscard]] double probability(double intensity) const;
};

/// The parameters of a law that have intervals.
enum class SuiteQuantity : std::uint8_t { median, dispersion, between_records, within_record };
[[nodiscard]] double value_of(SuiteQuantity quantity, const SuiteLaw& law);

/// Laws of bootstrap samples: each draws as many records as there are, with replacement, and keeps all trials of a
/// record together. Valid whatever the dependence of trials of one record. Where levels have records of their own, it draws
/// within each set of records with the same levels.
struct RecordBootstrap {
  std::uint64_t samples = 0;
  std::size_t fewest = 0;                     ///< records of the smallest set within which it draws
  std::vector<SuiteLaw> laws;                 ///< of the samples that have one
  std::vector<std::size_t> samples_with_law;  ///< the sample of each of them
  std::vector<std::vector<double>> weights;   ///< of each sample: how many times each record is in it
  /// Of each sample shares of the records and, last, of a record that the suite does not have (suite_bootstrap.hpp).
  std::vector<std::vector<double>> with_unseen;
};

/// Coefficients of a probit regression on two regressors.
using SurfaceCoefficients = std::array<double, 4>;

/// c0 + c1 u + c2 v + c3 u v.
[[nodiscard]] constexpr double surface_probit(const SurfaceCoefficients& c, double u, double v) {
  return c[0] + c[1] * u + (c[2] + c[3] * u) * v;
}

/// Wald test that some coefficients are zero, with the covariance of trials that are independent between records only
/// (Liang and Zeger 1986, Biometrika 73, 13-22). Its p-value is by bootstrap over records of the same statistic about the
/// estimates (Cameron, Gelbach and Miller 2008, Rev. Econ. Stat. 90, 414-427): with few records it is not chi^2.
struct SurfaceTest {
  double wald = 0.0;
  std::uint64_t samples = 0;                     ///< in which the likelihood has a maximum
  std::uint64_t as_large = 0;                    ///< of them
  std::optional<double> p_value = std::nullopt;  ///< (as_large + 1)/(samples + 1); absent: too few samples
};

inline constexpr double surface_significance = 0.05;

}  // namespace rocking::stats
