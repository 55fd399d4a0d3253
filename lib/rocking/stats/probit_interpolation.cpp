#include "rocking/stats/probit_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

ProbitInterpolation::ProbitInterpolation(const std::vector<KnownProbability>& points) {
  constexpr double least = 1e-9;  // 0 and 1 have no probit; a curve drawn 1e-9 from them cannot be told apart
  ROCKING_EXPECT(points.size() >= 2);
  const boost::math::normal_distribution<double> normal;
  for (const KnownProbability& point : points) {
    ROCKING_EXPECT(point.intensity > 0.0);
    nodes_.push_back({.logarithm = std::log(point.intensity),
                      .probit = quantile(normal, std::clamp(point.probability, least, 1.0 - least))});
  }
}

double ProbitInterpolation::probability(double intensity) const {
  const double at = std::log(intensity);
  std::size_t next = 1;
  while (next + 1 < nodes_.size() && nodes_[next].logarithm < at) ++next;
  const Node& low = nodes_[next - 1];
  const Node& high = nodes_[next];
  const double part = (at - low.logarithm) / (high.logarithm - low.logarithm);
  return normal_cdf((1.0 - part) * low.probit + part * high.probit);
}

}  // namespace rocking::stats
