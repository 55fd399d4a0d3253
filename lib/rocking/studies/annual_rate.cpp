#include "rocking/studies/run_fragility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/student_law.hpp"
#include "rocking/studies/counted_hazard.hpp"

namespace rocking {
namespace {

LognormalCapacity capacity_of(const stats::LognormalFragility& law) {
  return {.centre = law.centre - law.intercept / law.slope, .dispersion = 1.0 / law.slope};
}

AnnualRate rate_by_law(const FragilityCurve& curve, const CountedHazard& counted) {
  const stats::LognormalFragility& law = curve.law.value().function;
  AnnualRate found = disaggregated(counted, capacity_of(law));
  const std::vector<HazardPiece> pieces = pieces_between(counted.hazard, counted.start);
  // Derivatives of ln rate by (a, b), from central differences of a hundredth of a standard error.
  const auto derivative = [&](double stats::LognormalFragility::*parameter, double variance) {
    const double step = 0.01 * std::sqrt(variance);
    stats::LognormalFragility low = law;
    stats::LognormalFragility high = law;
    low.*parameter -= step;
    high.*parameter += step;
    return (std::log(rate_of(capacity_of(high), pieces)) - std::log(rate_of(capacity_of(low), pieces))) / (2.0 * step);
  };
  const double by_a = derivative(&stats::LognormalFragility::intercept, law.covariance.aa);
  const double by_b = derivative(&stats::LognormalFragility::slope, law.covariance.bb);
  const double variance =
      by_a * by_a * law.covariance.aa + 2.0 * by_a * by_b * law.covariance.ab + by_b * by_b * law.covariance.bb;
  if (!std::isfinite(variance)) return found;  // the rate is too small for a double
  const double reach = stats::two_sided_t_quantile(curve.subject.confidence, law.degrees_of_freedom);
  const double factor = std::exp(reach * std::sqrt(std::max(0.0, variance)));
  found.interval = stats::Interval{.low = found.value / factor, .high = found.value * factor};
  return found;
}

AnnualRate rate_by_levels(const FragilityCurve& curve, const CountedHazard& counted) {
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
  AnnualRate found = disaggregated(counted, KnownProbabilities{y, std::move(estimates), linear});
  found.source = RateSource::levels;
  const std::vector<HazardPiece> pieces = pieces_between(counted.hazard, counted.start);
  found.interval = stats::Interval{.low = rate_of(KnownProbabilities{y, std::move(lows), last_known}, pieces),
                                   .high = rate_of(KnownProbabilities{y, std::move(highs), next_known}, pieces)};
  return found;
}

}  // namespace

AnnualRate annual_rate(const FragilityCurve& curve, const HazardCurve& hazard) {
  ROCKING_EXPECT(!curve.levels.empty());
  const CountedHazard what = counted_hazard(hazard, curve.levels, curve.subject.least_uplift);
  return curve.law ? rate_by_law(curve, what) : rate_by_levels(curve, what);
}

}  // namespace rocking
