#include "rocking/studies/fragility/shares_and_hazard.hpp"

#include <algorithm>
#include <cmath>

namespace rocking {

SharesAndHazard::SharesAndHazard(const CountedHazard& counted, std::size_t levels, const SuiteTail& tail)
    : hazard_(counted.hazard),
      tail_(tail),
      start_(counted.start),
      least_uplift_(counted.least_uplift),
      pieces_(counted.pieces()),
      is_below_uplift_(counted.levels.empty()),
      skipped_(levels - (counted.levels.size() - tail.size())) {
  // A suite without a level that lifts the block does not overturn up to there.
  intensities_ = is_below_uplift_ ? std::vector<double>{start_} : counted.levels;
  for (std::size_t k = 0; k < intensities_.size(); ++k) {
    std::vector<double> unit(intensities_.size(), 0.0);
    unit[k] = 1.0;
    weights_.push_back(rate_of(known(unit), pieces_));
    ranges_.push_back(hazard_between(k == 0 ? start_ : intensities_[k - 1], intensities_[k]));
  }
  ranges_.push_back(hazard_between(intensities_.back(), std::nullopt));
  pieces_below_ = pieces_between(hazard_, start_, intensities_.front());
  pieces_above_ = pieces_between(hazard_, std::max(start_, intensities_.back()));
}

std::vector<double> SharesAndHazard::counted_of(std::vector<double> shares, const std::vector<double>& tail) const {
  if (is_below_uplift_) return {0.0};
  shares.erase(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(skipped_));
  // Where the highest estimate ends the tail, the levels above show no event, and the probability is no smaller there.
  if (tail_.size() > 0 && !tail_.used().end) {
    for (double& share : shares) share = std::max(share, tail.back());
  }
  shares.insert(shares.begin(), tail.begin(), tail.end());
  return shares;
}

WithTail<KnownProbabilities> SharesAndHazard::probability(const std::vector<double>& counted) const {
  return {tail_.y(), {counted.begin(), counted.begin() + static_cast<std::ptrdiff_t>(tail_.size())}, known(counted)};
}

double SharesAndHazard::rate(const std::vector<double>& shares) const {
  if (tail_.size() > 0) return rate_of(probability(shares), pieces_);
  double sum = 0.0;
  for (std::size_t k = 0; k < weights_.size(); ++k) sum += weights_[k] * shares[k];
  return sum;
}

double SharesAndHazard::at_least(const std::vector<double>& shares, std::size_t from) const {
  double sum = shares.back() * ranges_.back();
  for (std::size_t k = from; k < shares.size(); ++k) sum += std::min(shares[k - 1], shares[k]) * ranges_[k];
  return sum;
}

double SharesAndHazard::at_most(const std::vector<double>& shares, std::size_t from) const {
  double sum = shares.front() * ranges_.front() + ranges_.back();
  for (std::size_t k = from; k < shares.size(); ++k) sum += std::max(shares[k - 1], shares[k]) * ranges_[k];
  return sum;
}

double SharesAndHazard::least_allowed(const std::vector<double>& shares) const {
  return in_tail(shares) + at_least(shares, first_of_levels());
}

double SharesAndHazard::most_allowed(const std::vector<double>& shares) const {
  return in_tail(shares) + at_most(shares, first_of_levels());
}

std::vector<double> SharesAndHazard::worst_unseen(const std::vector<std::vector<double>>& counted_of_records) const {
  std::vector<double> worst(intensities_.size(), 1.0);
  for (std::size_t k = 0; k + 1 < intensities_.size() && 2.0 * intensities_[k] <= intensities_.back(); ++k) {
    const auto beyond = std::ranges::upper_bound(intensities_, 2.0 * intensities_[k]);
    const std::size_t last = std::max<std::size_t>(static_cast<std::size_t>(beyond - intensities_.begin()) - 1, k + 1);
    worst[k] = 0.0;
    for (const std::vector<double>& record : counted_of_records) {
      worst[k] =
          std::max(worst[k], *std::max_element(record.begin(), record.begin() + static_cast<std::ptrdiff_t>(last) + 1));
    }
  }
  return worst;
}

AllowedRate SharesAndHazard::allowed(const std::vector<double>& shares, double half_trial) const {
  AllowedRate found{.linear = allowed_outside(probability(shares), rate(shares), shares), .lognormal = {}};
  const std::vector<LevelShare> at = levels(shares, half_trial);
  double more = 0.0;
  for (std::size_t k = first_of_levels(); k < at.size(); ++k) {
    more += lognormal_less_linear(at[k - 1], at[k], hazard_);
  }
  found.lognormal = {.low = std::max(0.0, found.linear.low + more), .high = found.linear.high + more};
  return found;
}

std::vector<LevelShare> SharesAndHazard::levels(const std::vector<double>& shares, double half_trial) const {
  std::vector<LevelShare> list;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    // A rare estimate is told from 0.
    const double least = k < tail_.size() ? std::min(half_trial, shares[k]) : half_trial;
    list.push_back({intensities_[k], shares[k], least});
  }
  return list;
}

double SharesAndHazard::in_tail(const std::vector<double>& shares) const {
  if (tail_.size() == 0) return 0.0;
  return rate_of(probability(shares), pieces_within(pieces_, tail_.y().front(), tail_.y().back()));
}

KnownProbabilities SharesAndHazard::known(const std::vector<double>& shares) const {
  KnownProbabilities found;
  const bool has_zero = least_uplift_ && *least_uplift_ < intensities_.front();
  if (has_zero) found = {.y = {std::log(*least_uplift_)}, .probabilities = {0.0}};
  for (const double intensity : intensities_) found.y.push_back(std::log(intensity));
  found.probabilities.insert(found.probabilities.end(), shares.begin(), shares.end());
  return found;
}

double SharesAndHazard::hazard_between(double from, std::optional<double> to) const {
  const std::vector<HazardPiece> pieces = pieces_between(hazard_, std::max(from, start_), to);
  return rate_of(KnownProbabilities{.y = {0.0}, .probabilities = {1.0}}, pieces);
}

}  // namespace rocking
