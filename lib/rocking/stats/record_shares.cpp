#include "rocking/stats/record_shares.hpp"

#include "rocking/base/error.hpp"
#include "rocking/stats/isotonic.hpp"

namespace rocking::stats {

RecordShares::RecordShares(const SuiteLevels& suite, Unresolved unresolved) {
  ROCKING_EXPECT(!suite.empty());
  for (const RecordLevel& level : suite.front()) intensities_.push_back(level.intensity);
  for (const auto& record : suite) {
    ROCKING_EXPECT(record.size() == intensities_.size());
    std::vector<double>& shares = shares_.emplace_back();
    for (std::size_t k = 0; k < record.size(); ++k) {
      ROCKING_EXPECT(record[k].intensity == intensities_[k]);
      const std::uint64_t more = unresolved == Unresolved::as_happened ? record[k].unresolved : 0;
      shares.push_back(static_cast<double>(record[k].happened.successes + more) /
                       static_cast<double>(record[k].happened.trials));
    }
  }
}

std::vector<double> RecordShares::mean(const std::vector<double>& weights) const {
  ROCKING_EXPECT(weights.size() == records());
  std::vector<double> means(intensities_.size(), 0.0);
  double sum = 0.0;
  for (std::size_t r = 0; r < records(); ++r) {
    sum += weights[r];
    for (std::size_t k = 0; k < means.size(); ++k) means[k] += weights[r] * shares_[r][k];
  }
  for (double& mean : means) mean /= sum;
  return means;
}

std::vector<double> RecordShares::isotonic(const std::vector<double>& weights) const {
  return isotonic_regression(mean(weights), std::vector<double>(intensities_.size(), 1.0));
}

}  // namespace rocking::stats
