#include "rocking/stats/repetitions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/stats/mean_share.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

constexpr double rounding_of_mean = 1e-14;  ///< of a mean

/// Student's interval for the logarithm.
Interval interval_about(double mean, double relative_error, double degrees_of_freedom, double confidence) {
  const double t = two_sided_t_quantile(confidence, degrees_of_freedom);
  return {mean * std::exp(-t * relative_error), mean * std::exp(t * relative_error)};
}

/// Variance of a repetition over the square of the mean, by the scatter of its logarithm: that of a lognormal law, with a
/// share of zeros beside it. 0 from fewer than two estimates > 0.
double lognormal_variance(std::span<const double> estimates) {
  constexpr double most = 700.0;  // e^700 is finite
  double positive = 0.0;
  double mean = 0.0;
  double squares = 0.0;  // of deviations from the mean (Welford)
  for (const double estimate : estimates) {
    if (!(estimate >= std::numeric_limits<double>::min())) continue;
    const double logarithm = base::natural_logarithm(estimate);
    positive += 1.0;
    const double deviation = logarithm - mean;
    mean += deviation / positive;
    squares += deviation * (logarithm - mean);
  }
  if (positive < 2.0) return 0.0;
  const double second_moment = base::exponential(std::min(most, squares / (positive - 1.0)));
  return second_moment * static_cast<double>(estimates.size()) / positive - 1.0;
}

}  // namespace

RepeatedEstimate mean_of_repetitions(std::span<const double> estimates, double confidence) {
  ROCKING_EXPECT(!estimates.empty());
  const auto count = static_cast<double>(estimates.size());
  RepeatedEstimate result;
  for (const double estimate : estimates) result.mean += estimate;
  result.mean /= count;
  if (estimates.size() < 2 || !(result.mean > 0.0)) return result;
  double squares = 0.0;
  for (const double estimate : estimates) {
    const double deviation = estimate / result.mean - 1.0;  // relative, so that no square underflows
    squares += deviation * deviation;
  }
  constexpr double most_times = 2.0;
  const double sampled = std::sqrt(squares / (count - 1.0) / count);
  const double lognormal = std::sqrt(lognormal_variance(estimates) / count);
  const double error = std::max(sampled, std::min(most_times * sampled, lognormal));
  result.relative_error = error;
  result.degrees_of_freedom = count - 1.0;
  result.interval = interval_about(result.mean, error, result.degrees_of_freedom, confidence);
  if (error <= rounding_of_mean) {
    result.relative_error = 0.0;
    result.interval = interval_of_equal_shares(std::min(1.0, result.mean), estimates.size(), confidence);
  }
  return result;
}

RepeatedEstimate sum_of_strata(std::span<const Stratum> strata, double confidence) {
  ROCKING_EXPECT(!strata.empty());
  RepeatedEstimate result;
  for (const Stratum& stratum : strata) result.mean += stratum.mean;
  double variance = 0.0;  // over the square of the sum
  double of_variance = 0.0;
  for (const Stratum& stratum : strata) {
    const double error = stratum.standard_error / result.mean;
    variance += error * error;
    of_variance += error * error * error * error / stratum.degrees_of_freedom;
  }
  result.relative_error = std::sqrt(variance);
  result.interval = Interval{result.mean, result.mean};
  if (of_variance > 0.0) {
    result.degrees_of_freedom = variance * variance / of_variance;
    result.interval = interval_about(result.mean, *result.relative_error, result.degrees_of_freedom, confidence);
  }
  return result;
}

}  // namespace rocking::stats
