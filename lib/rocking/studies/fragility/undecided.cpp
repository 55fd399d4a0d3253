#include "rocking/studies/fragility/undecided.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

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

double lognormal_less_linear(const LevelShare& low, const LevelShare& high, const HazardCurve& hazard) {
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

}  // namespace rocking
