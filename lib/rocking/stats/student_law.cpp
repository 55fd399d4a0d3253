#include "rocking/stats/student_law.hpp"

#include <cmath>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace rocking::stats {

double two_sided_t_quantile(double confidence, double degrees_of_freedom) {
  const double tail = 0.5 * (1.0 - confidence);
  if (std::isinf(degrees_of_freedom)) return quantile(complement(boost::math::normal_distribution<double>(), tail));
  return quantile(complement(boost::math::students_t_distribution<double>(degrees_of_freedom), tail));
}

}  // namespace rocking::stats
