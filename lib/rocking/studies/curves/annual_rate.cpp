#include "rocking/studies/curves/annual_rate.hpp"

#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/studies/curves/counted_hazard.hpp"
#include "rocking/studies/curves/rare_tail.hpp"

namespace rocking {
namespace {

LognormalCapacity capacity_of(const stats::LognormalFragility& law) {
  return {.centre = law.centre - law.intercept / law.slope, .dispersion = 1.0 / law.slope};
}

/// Rare estimates of the lower tail and what they add to a rate.
struct Tail : UsedRare {
  explicit Tail(const FragilityCurve& curve) : UsedRare(used_rare(curve)) {}

  /// The probabilities, after a change of one.
  template <class Get>
  [[nodiscard]] std::vector<double> probabilities(Get&& get) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < estimates.size(); ++i) all.push_back(get(i));
    return all;
  }
  [[nodiscard]] std::vector<double> probabilities() const {
    return probabilities([this](std::size_t i) { return estimates[i].probability; });
  }
  /// The probabilities of levels above the tail. Where the highest of its own, `last`, ends it, they are no smaller.
  [[nodiscard]] KnownProbabilities above(KnownProbabilities levels, double last) const {
    if (end || y.empty()) return levels;
    KnownProbabilities found{.y = {y.back()}, .probabilities = {last}, .between = levels.between};
    for (std::size_t i = 0; i < levels.y.size(); ++i) {
      if (levels.y[i] <= y.back()) continue;
      found.y.push_back(levels.y[i]);
      found.probabilities.push_back(std::max(last, levels.probabilities[i]));
    }
    return found;
  }
};

/// Levels, whose lowest part is a tail with these probabilities.
WithTail<KnownProbabilities> joined(const Tail& tail, const std::vector<double>& of_tail, KnownProbabilities levels) {
  return {tail.y, of_tail, tail.above(std::move(levels), of_tail.empty() ? 0.0 : of_tail.back())};
}

AnnualRate rate_by_law(const FragilityCurve& curve, const CountedHazard& counted, const Tail& tail) {
  const stats::LognormalFragility& law = curve.law.value().function;
  AnnualRate found = disaggregated(counted, WithTail(tail.y, tail.probabilities(), capacity_of(law)));
  const std::vector<HazardPiece> pieces = pieces_between(counted.hazard, counted.start);
  // Derivatives of ln rate by (a, b), from central differences of a hundredth of a standard error.
  const auto log_rate = [&](const stats::LognormalFragility& with, const std::vector<double>& probabilities) {
    return std::log(rate_of(WithTail(tail.y, probabilities, capacity_of(with)), pieces));
  };
  const auto derivative = [&](double stats::LognormalFragility::*parameter, double variance) {
    const double step = 0.01 * std::sqrt(variance);
    stats::LognormalFragility low = law;
    stats::LognormalFragility high = law;
    low.*parameter -= step;
    high.*parameter += step;
    return (log_rate(high, tail.probabilities()) - log_rate(low, tail.probabilities())) / (2.0 * step);
  };
  const double by_a = derivative(&stats::LognormalFragility::intercept, law.covariance.aa);
  const double by_b = derivative(&stats::LognormalFragility::slope, law.covariance.bb);
  const double of_law =
      by_a * by_a * law.covariance.aa + 2.0 * by_a * by_b * law.covariance.ab + by_b * by_b * law.covariance.bb;
  if (!std::isfinite(of_law)) return found;  // the rate is too small for a double
  double variance = std::max(0.0, of_law);
  double of_variance = variance * variance / law.degrees_of_freedom;
  for (std::size_t r = 0; r < tail.estimates.size(); ++r) {
    // The same by the logarithm of an estimate; they are independent of each other and of the run.
    constexpr double step = 0.01;
    const double error = tail.estimates[r].relative_error;
    const auto moved = [&](double sign) {
      return log_rate(law, tail.probabilities([&](std::size_t i) {
        return tail.estimates[i].probability * (i == r ? 1.0 + sign * step * error : 1.0);
      }));
    };
    const double part = (moved(1.0) - moved(-1.0)) / (2.0 * step);
    variance += part * part;
    of_variance += part * part * part * part / tail.estimates[r].degrees_of_freedom;
  }
  const double degrees =
      tail.y.empty() || !(of_variance > 0.0) ? law.degrees_of_freedom : variance * variance / of_variance;
  const double reach = stats::two_sided_t_quantile(curve.subject.confidence, degrees);
  const double factor = std::exp(reach * std::sqrt(variance));
  found.interval = stats::Interval{.low = found.value / factor, .high = found.value * factor};
  return found;
}

AnnualRate rate_by_levels(const FragilityCurve& curve, const CountedHazard& counted, const Tail& tail) {
  using enum KnownProbabilities::Between;
  std::vector<double> y, estimates, lows, highs;
  for (const FragilityLevel& level : curve.levels) {
    y.push_back(std::log(level.intensity));
    estimates.push_back(level.isotonic.value_or(level.estimate));
    // The lower ends hold also at stronger levels, and the upper ones at weaker levels.
    lows.push_back(std::max(lows.empty() ? 0.0 : lows.back(), level.simultaneous.low));
    highs.push_back(level.simultaneous.high);
  }
  for (std::size_t i = highs.size() - 1; i-- > 0;) highs[i] = std::min(highs[i], highs[i + 1]);
  AnnualRate found = disaggregated(counted, joined(tail, tail.probabilities(), {y, std::move(estimates), linear}));
  found.source = RateSource::levels;
  const std::vector<HazardPiece> pieces = pieces_between(counted.hazard, counted.start);
  const auto low = tail.probabilities([&](std::size_t i) { return tail.estimates[i].interval.low; });
  const auto high = tail.probabilities([&](std::size_t i) { return tail.estimates[i].interval.high; });
  found.interval = stats::Interval{.low = rate_of(joined(tail, low, {y, std::move(lows), last_known}), pieces),
                                   .high = rate_of(joined(tail, high, {y, std::move(highs), next_known}), pieces)};
  return found;
}

}  // namespace

AnnualRate annual_rate(const FragilityCurve& curve, const HazardCurve& hazard) {
  ROCKING_EXPECT(!curve.levels.empty());
  const Tail tail(curve);
  CountedHazard what = counted_hazard(hazard, curve.levels, curve.subject.least_uplift);
  if (!tail.estimates.empty()) {
    const CountedHazard rare = counted_hazard(hazard, tail.estimates, curve.subject.least_uplift);
    what.levels.insert(what.levels.end(), rare.levels.begin(), rare.levels.end());
    std::ranges::sort(what.levels);
  }
  AnnualRate found = curve.law ? rate_by_law(curve, what, tail) : rate_by_levels(curve, what, tail);
  found.rare_below = tail.reach();
  found.rare_use = tail.use;
  return found;
}

}  // namespace rocking
