#include "rocking/studies/fragility/suite_tail.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking {

SuiteTail::SuiteTail(const SuiteCurve& curve) : used_(used_rare(curve)), y_(used_.nodes()) {
  for (const RecordCurve& record : curve.records) {
    std::vector<double>& probabilities = of_records_.emplace_back(size(), 0.0);
    for (const RareLevel& level : record.curve.rare) {
      const auto node = std::ranges::find(used_.estimates, level.intensity, &RareLevel::intensity);
      if (node != used_.estimates.end()) {
        probabilities[static_cast<std::size_t>(node - used_.estimates.begin())] = level.probability;
      }
    }
  }
}

std::vector<double> SuiteTail::means(const std::vector<double>& weights) const {
  std::vector<double> sums(size(), 0.0);
  if (sums.empty()) return sums;
  ROCKING_EXPECT(weights.size() == of_records_.size());
  double total = 0.0;
  for (std::size_t r = 0; r < weights.size(); ++r) {
    total += weights[r];
    for (std::size_t node = 0; node < size(); ++node) sums[node] += weights[r] * of_records_[r][node];
  }
  for (double& sum : sums) sum /= total;
  return sums;
}

}  // namespace rocking
