#include "rocking/studies/fragility/rare_tail.hpp"

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"

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

SuiteTail::SuiteTail(const SuiteCurve& curve) : UsedRare(used_rare(curve)), y(nodes()) {
  for (const RecordCurve& record : curve.records) {
    std::vector<double>& probabilities = of_records.emplace_back(estimates.size(), 0.0);
    for (const RareLevel& level : record.curve.rare) {
      const auto node = std::ranges::find(estimates, level.intensity, &RareLevel::intensity);
      if (node != estimates.end()) {
        probabilities[static_cast<std::size_t>(node - estimates.begin())] = level.probability;
      }
    }
  }
}

std::vector<double> SuiteTail::means(const std::vector<double>& weights) const {
  std::vector<double> sums(estimates.size(), 0.0);
  if (sums.empty()) return sums;
  ROCKING_EXPECT(weights.size() == of_records.size());
  double total = 0.0;
  for (std::size_t r = 0; r < weights.size(); ++r) {
    total += weights[r];
    for (std::size_t node = 0; node < estimates.size(); ++node) sums[node] += weights[r] * of_records[r][node];
  }
  for (double& sum : sums) sum /= total;
  return sums;
}

}  // namespace rocking
