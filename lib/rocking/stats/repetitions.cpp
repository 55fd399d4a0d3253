#include "rocking/stats/repetitions.hpp"

#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/student_law.hpp"

namespace rocking::stats {
namespace {

/// Student's interval for the logarithm.
Interval interval_about(double mean, double relative_error, double degrees_of_freedom, double confidence) {
  const double t = two_sided_t_quantile(confidence, degrees_of_freedom);
  return {mean * std::exp(-t * relative_error), mean * std::exp(t * relative_error)};
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
  const double error = std::sqrt(squares / (count - 1.0) / count);
  result.relative_error = error;
  result.degrees_of_freedom = count - 1.0;
  result.interval = interval_about(result.mean, error, result.degrees_of_freedom, confidence);
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
