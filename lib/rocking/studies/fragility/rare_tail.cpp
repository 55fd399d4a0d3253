#include "rocking/studies/fragility/rare_tail.hpp"

#include <boost/math/distributions/normal.hpp>

namespace rocking {

TailPiece tail_piece(double y_low, double p_low, double y_high, double p_high) {
  if (!(0.0 < p_low && p_low < p_high && p_high < 1.0)) {
    return KnownProbabilities{.y = {y_low, y_high}, .probabilities = {p_low, p_high}};
  }
  const boost::math::normal_distribution<double> normal;
  const double z_low = boost::math::quantile(normal, p_low);
  const double dispersion = (y_high - y_low) / (boost::math::quantile(normal, p_high) - z_low);
  return LognormalCapacity{.centre = y_low - z_low * dispersion, .dispersion = dispersion};
}

}  // namespace rocking
