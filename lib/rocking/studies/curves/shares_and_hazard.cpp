#include "rocking/studies/curves/shares_and_hazard.hpp"

#include <charconv>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_levels = 8;
/// The step beyond the last level.
constexpr double next_level = 1.25;

double probit(const LevelShare& level) {
  const boost::math::normal_distribution<double> normal;
  return quantile(normal, std::clamp(level.share, level.half_trial, 1.0 - level.half_trial));
}

double rate_between(const LevelShare& low, const LevelShare& high, const std::vector<HazardPiece>& pieces) {
  return rate_of(KnownProbabilities{.y = {std::log(low.intensity), std::log(high.intensity)},
                                    .probabilities = {low.share, high.share}},
                 pieces);
}

}  // namespace

/// The rate between two levels of the lognormal curve through their shares, less that of the curve linear in ln x; 0 where
/// the shares do not rise.
static double lognormal_less_linear(const LevelShare& low, const LevelShare& high, const HazardCurve& hazard) {
  const double rise = probit(high) - probit(low);
  const double length = std::log(high.intensity / low.intensity);
  if (!(rise > 0.0) || !(length > 0.0)) return 0.0;
  const double dispersion = length / rise;
  const LognormalCapacity lognormal{.centre = std::log(low.intensity) - probit(low) * dispersion,
                                    .dispersion = dispersion};
  const std::vector<HazardPiece> pieces = pieces_between(hazard, low.intensity, high.intensity);
  return rate_of(lognormal, pieces) - rate_between(low, high, pieces);
}

namespace {

double hazard_between(const HazardCurve& hazard, double from, std::optional<double> to) {
  return rate_of(KnownProbabilities{.y = {std::log(from)}, .probabilities = {1.0}}, pieces_between(hazard, from, to));
}

/// The number with so many digits that lies nearest.
double rounded(double value, int digits) {
  const std::string text = base::significant(value, digits);
  double number = value;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

std::vector<UndecidedRange> undecided_ranges(const std::vector<LevelShare>& levels, const HazardCurve& hazard,
                                             double start) {
  std::vector<UndecidedRange> ranges;
  const LevelShare& first = levels.front();
  const LevelShare& last = levels.back();
  if (start < first.intensity) {
    ranges.push_back({start, first.intensity, first.share * hazard_between(hazard, start, first.intensity)});
  }
  for (std::size_t k = 1; k < levels.size(); ++k) {
    ranges.push_back({levels[k - 1].intensity, levels[k].intensity,
                      std::abs(lognormal_less_linear(levels[k - 1], levels[k], hazard))});
  }
  ranges.push_back({last.intensity, std::nullopt,
                    (1.0 - last.share) * hazard_between(hazard, std::max(start, last.intensity), std::nullopt)});
  return ranges;
}

double inside(double from, std::optional<double> to) {
  const double exact = to ? std::sqrt(from * *to) : from * next_level;
  for (int digits = 2; digits < 6; ++digits) {
    const double tried = rounded(exact, digits);
    const double reach = to ? 0.25 * std::log(*to / from) : 0.25 * std::log(next_level);
    if (std::abs(std::log(tried / exact)) <= reach) return tried;
  }
  return exact;
}

std::vector<double> levels_to_add(std::vector<LevelShare> levels, const HazardCurve& hazard, double start, double goal,
                                  const std::function<double(double)>& expected) {
  std::vector<double> added;
  while (added.size() < most_levels) {
    const std::vector<UndecidedRange> ranges = undecided_ranges(levels, hazard, start);
    double open = 0.0;
    for (const UndecidedRange& range : ranges) open += range.rate;
    if (!(open > goal)) break;
    const UndecidedRange worst = *std::ranges::max_element(ranges, {}, &UndecidedRange::rate);
    const double intensity = inside(worst.from, worst.to);
    const auto next = std::ranges::upper_bound(levels, intensity, {}, &LevelShare::intensity);
    const double least = next == levels.begin() ? 0.0 : std::prev(next)->share;
    const double most = next == levels.end() ? 1.0 : next->share;
    levels.insert(next, {.intensity = intensity,
                         .share = std::clamp(expected(intensity), std::min(least, most), std::max(least, most)),
                         .half_trial = (next == levels.begin() ? next : std::prev(next))->half_trial});
    added.push_back(intensity);
  }
  std::ranges::sort(added);
  return added;
}

SharesAndHazard::SharesAndHazard(const CountedHazard& counted, std::size_t levels, const SuiteTail& tail)
    : hazard_(counted.hazard),
      tail_(tail),
      start_(counted.start),
      least_uplift_(counted.least_uplift),
      pieces_(counted.pieces()),
      is_below_uplift_(counted.levels.empty()),
      skipped_(levels - (counted.levels.size() - tail.estimates.size())) {
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
  if (!tail_.estimates.empty() && !tail_.end) {
    for (double& share : shares) share = std::max(share, tail.back());
  }
  shares.insert(shares.begin(), tail.begin(), tail.end());
  return shares;
}

WithTail<KnownProbabilities> SharesAndHazard::probability(const std::vector<double>& counted) const {
  return {tail_.y,
          {counted.begin(), counted.begin() + static_cast<std::ptrdiff_t>(tail_.estimates.size())},
          known(counted)};
}

double SharesAndHazard::rate(const std::vector<double>& shares) const {
  if (!tail_.estimates.empty()) return rate_of(probability(shares), pieces_);
  double sum = 0.0;
  for (std::size_t k = 0; k < weights_.size(); ++k) sum += weights_[k] * shares[k];
  return sum;
}

double SharesAndHazard::least_allowed(const std::vector<double>& shares) const {
  double sum = in_tail(shares) + shares.back() * ranges_.back();
  for (std::size_t k = first_of_levels(); k < shares.size(); ++k)
    sum += std::min(shares[k - 1], shares[k]) * ranges_[k];
  return sum;
}

double SharesAndHazard::most_allowed(const std::vector<double>& shares) const {
  double sum = in_tail(shares) + shares.front() * ranges_.front() + ranges_.back();
  for (std::size_t k = first_of_levels(); k < shares.size(); ++k)
    sum += std::max(shares[k - 1], shares[k]) * ranges_[k];
  return sum;
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
    const double least = k < tail_.estimates.size() ? std::min(half_trial, shares[k]) : half_trial;
    list.push_back({intensities_[k], shares[k], least});
  }
  return list;
}

double SharesAndHazard::in_tail(const std::vector<double>& shares) const {
  if (tail_.estimates.empty()) return 0.0;
  return rate_of(probability(shares), pieces_within(pieces_, tail_.y.front(), tail_.y.back()));
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
