#include "rocking/stats/unseen_record.hpp"

#include <cmath>

#include "rocking/base/error.hpp"

namespace rocking::stats {

// Exponential numbers over their sum.
std::vector<double> shares_with_unseen(std::size_t records, std::uint64_t sample, const RecordDraws& draws) {
  std::vector<double> shares;
  double sum = 0.0;
  for (std::size_t number = 0; number <= records; ++number) {
    shares.push_back(-std::log1p(-draws(sample, number)));
    sum += shares.back();
  }
  ROCKING_EXPECT(sum > 0.0);
  for (double& share : shares) share /= sum;
  return shares;
}

std::vector<double> mean_with_unseen(std::vector<double> mean, double share_of_unseen, std::span<const double> unseen) {
  ROCKING_EXPECT(mean.size() == unseen.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = (1.0 - share_of_unseen) * mean[k] + share_of_unseen * unseen[k];
  }
  return mean;
}

}  // namespace rocking::stats
