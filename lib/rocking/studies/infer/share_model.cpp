#include "rocking/studies/infer/share_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rocking::infer {
namespace {

/// Groups by their numbers over all points, the most frequent first; of equal ones the first.
std::vector<std::size_t> by_frequency(const std::vector<std::vector<std::uint64_t>>& counts) {
  std::vector<std::uint64_t> sums(counts.front().size());
  for (const auto& at_point : counts) {
    for (std::size_t group = 0; group < sums.size(); ++group) sums[group] += at_point[group];
  }
  std::vector<std::size_t> order(sums.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
  return order;
}

/// ln(1/(1 + e^-x)).
double log_share(double log_odds) { return std::min(log_odds, 0.0) - std::log1p(std::exp(-std::abs(log_odds))); }

}  // namespace

ShareModel::ShareModel(const Eigen::MatrixXd& points, const std::vector<std::vector<std::uint64_t>>& counts,
                       const ShareModel* former, base::StopRequest stop)
    : order_(by_frequency(counts)), unknowns_(static_cast<std::size_t>(points.cols())) {
  std::vector<std::uint64_t> left;
  for (const auto& at_point : counts) {
    left.push_back(std::accumulate(at_point.begin(), at_point.end(), std::uint64_t{0}));
  }
  realisations_ = static_cast<double>(*std::ranges::min_element(left));
  for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
    std::vector<stats::Proportion> taken;
    for (std::size_t j = 0; j < counts.size(); ++j) {
      taken.push_back({.successes = counts[j][order_[i]], .trials = left[j]});
      left[j] -= counts[j][order_[i]];
    }
    const bool is_known = former != nullptr && former->order_ == order_;
    processes_.push_back(stats::BinomialProcess::fit(
        points, taken, is_known ? former->processes_[i].scales() : stats::ProcessScales{}, stop));
  }
}

Eigen::VectorXd ShareModel::log_shares(const Eigen::VectorXd& point) const {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(order_.size()));
  double left = 0.0;  // logarithm of what is left
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    const double log_odds = processes_[i].mean_at(point);
    shares[static_cast<Eigen::Index>(order_[i])] = left + log_share(log_odds);
    left += log_share(-log_odds);
  }
  shares[static_cast<Eigen::Index>(order_.back())] = left;
  return shares;
}

UncertainShares ShareModel::uncertain_shares(const Eigen::VectorXd& point) const {
  UncertainShares shares{.groups = {}, .last = order_.back(), .realisations = realisations_};
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    const stats::LogOdds log_odds = processes_[i].at(point);
    const double share = std::exp(log_share(log_odds.mean));
    shares.groups.push_back({.group = order_[i],
                             .angle = std::asin(std::sqrt(share)),
                             .error = 0.5 * std::sqrt(share * (1.0 - share)) * log_odds.deviation});
  }
  return shares;
}

Eigen::VectorXd UncertainShares::moved(std::span<const double> numbers) const {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(groups.size() + 1));
  double left = 1.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double of_one_point = 0.5 / std::sqrt(std::max(realisations * left, 1.0));
    const double angle = groups[i].angle + numbers[i] * std::max(groups[i].error, of_one_point);
    const double share = std::pow(std::sin(std::clamp(angle, 0.0, std::asin(1.0))), 2);
    shares[static_cast<Eigen::Index>(groups[i].group)] = left * share;
    left *= 1.0 - share;
  }
  shares[static_cast<Eigen::Index>(last)] = left;
  return shares;
}

}  // namespace rocking::infer
