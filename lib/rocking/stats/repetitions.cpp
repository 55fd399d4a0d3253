#include "rocking/stats/repetitions.hpp"

#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/student_law.hpp"

namespace rocking::stats {

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
  const double t = two_sided_t_quantile(confidence, count - 1.0);
  result.relative_error = error;
  result.interval = Interval{result.mean * std::exp(-t * error), result.mean * std::exp(t * error)};
  return result;
}

}  // namespace rocking::stats
