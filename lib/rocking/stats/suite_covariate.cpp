#include "rocking/stats/suite_covariate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// Numbers less their mean, over their standard deviation; empty where they are equal.
std::vector<double> standardised(std::vector<double> numbers, double& deviation) {
  const auto count = static_cast<double>(numbers.size());
  double mean = 0.0, squares = 0.0;
  for (const double number : numbers) mean += number / count;
  for (double& number : numbers) {
    number -= mean;
    squares += number * number / count;
  }
  deviation = std::sqrt(squares);
  if (!(deviation > 1e-9 * (1.0 + std::abs(mean)))) return {};
  for (double& number : numbers) number /= deviation;
  return numbers;
}

}  // namespace

std::optional<SuiteCovariate> suite_covariate(const SuiteLevels& suite, const std::vector<double>& numbers) {
  ROCKING_EXPECT(numbers.size() == suite.size());
  double deviation = 0.0;
  const std::vector<double> z = standardised(numbers, deviation);
  const auto plain = fit_suite(suite).law;
  if (suite.size() < 4 || z.empty() || !plain) return std::nullopt;
  const auto loss = [&](double slope) {
    SuiteLevels moved = suite;
    for (std::size_t r = 0; r < moved.size(); ++r) {
      for (RecordLevel& level : moved[r]) level.intensity *= std::exp(-slope * z[r]);
    }
    const auto law = fit_suite_near(moved, *plain).law;
    return law ? -law->log_likelihood : std::numeric_limits<double>::max();
  };
  // A slope by one standard deviation of the numbers explains at most the dispersion.
  const double reach = 2.0 * plain->dispersion();
  const auto [slope, least] = boost::math::tools::brent_find_minima(loss, -reach, reach, 20);
  const double gain = std::max(0.0, -least - plain->log_likelihood);
  const boost::math::students_t_distribution<double> student(static_cast<double>(suite.size()) - 2.0);
  return SuiteCovariate{.slope = slope / deviation, .p_value = 2.0 * cdf(complement(student, std::sqrt(2.0 * gain)))};
}

}  // namespace rocking::stats
