#pragma once

#include <optional>
#include <span>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// The mean of independent, unbiased, non-negative estimates of a probability > 0.
struct RepeatedEstimate {
  double mean = 0.0;
  std::optional<double> relative_error;  ///< standard error over the mean; absent for a mean of 0 or one estimate
  std::optional<Interval> interval;      ///< absent likewise
  double degrees_of_freedom = 1.0;       ///< of the standard error; 1 without one
};

/// Mean, standard error and confidence interval from repetitions:
///
///     mean exp(-+ t e),   e = max(s/(mean sqrt(n)), e_log),   t the quantile of Student's law, n - 1 degrees of freedom
///
/// e_log is the standard error that a lognormal law with the same scatter of logarithms has, at most twice the other one.
/// Of skewed estimates s is too small, and the mean with it, until one of the rare large ones has come; the logarithms
/// tell their scatter before. Student's interval for the logarithm of the mean, by the delta method: the error of
/// estimates of a small probability
/// is nearer to lognormal than to normal, and the lower end stays positive. The coverage is measured in
/// lib/docs/rare.md. `confidence` in (0, 1). Requires an estimate. Where all are equal, as those of an event that always
/// happens, nothing is known of their scatter: each counts as one trial (interval_of_equal_shares).
[[nodiscard]] RepeatedEstimate mean_of_repetitions(std::span<const double> estimates, double confidence);

/// An independent estimate of a number > 0.
struct Stratum {
  double mean = 0.0;                ///< > 0
  double standard_error = 0.0;      ///< >= 0
  double degrees_of_freedom = 1.0;  ///< of the standard error, > 0
};

/// The sum of the strata, in the same way: the variance is the sum of theirs, with the degrees of freedom of Welch and
/// Satterthwaite, (sum v)^2/sum(v^2/degrees). Source: Welch (1947), Biometrika 34, 28-35. Requires a stratum.
[[nodiscard]] RepeatedEstimate sum_of_strata(std::span<const Stratum> strata, double confidence);

}  // namespace rocking::stats
