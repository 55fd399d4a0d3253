#include "rocking/studies/run_fragility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/student_law.hpp"
#include "rocking/studies/hazard_integral.hpp"

namespace rocking {
namespace {

/// Intensities that differ by less are the same level: the least intensity of uplift is computed from a record's peak.
constexpr double rounding = 1e-12;

/// What is counted: the hazard from `start` on, and the levels.
struct Counted {
  const HazardCurve& hazard;
  double first;                ///< lowest intensity of the hazard curve
  double start;                ///< the same, or the least intensity that lifts the block
  std::vector<double> levels;  ///< that can lift the block; rising
};

template <class Levels>
Counted counted(const HazardCurve& hazard, const Levels& levels, std::optional<double> least_uplift) {
  const double first = hazard.points.front().intensity;
  Counted found{.hazard = hazard, .first = first, .start = std::max(first, least_uplift.value_or(first)), .levels = {}};
  for (const auto& level : levels) {
    if (level.intensity >= least_uplift.value_or(0.0) * (1.0 - rounding)) found.levels.push_back(level.intensity);
  }
  return found;
}

/// Ends of the ranges of a disaggregation: where the rate starts, and the levels above it.
std::vector<double> ends_of_ranges(const Counted& counted) {
  std::vector<double> ends{counted.start};
  for (const double level : counted.levels) {
    if (level > ends.back() * (1.0 + rounding)) ends.push_back(level);
  }
  return ends;
}

/// Value and disaggregation.
template <class Probability>
AnnualRate disaggregated(const Counted& counted, const Probability& probability) {
  AnnualRate found;
  found.is_measure_assumed = counted.hazard.intensity.empty();
  found.impossible = rate_of(probability, pieces_between(counted.hazard, counted.first, counted.start));
  if (counted.start == counted.first) found.probability_at_first = probability.probability(std::log(counted.first));
  const std::vector<double> ends = ends_of_ranges(counted);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    RateInRange range;
    range.from = ends[i];
    if (i + 1 < ends.size()) range.to = ends[i + 1];
    range.rate = rate_of(probability, pieces_between(counted.hazard, range.from, range.to));
    const bool is_below = counted.levels.empty() || range.from < counted.levels.front() * (1.0 - rounding);
    range.is_tested = !is_below && range.to.has_value();
    found.value += range.rate;
    if (is_below) found.below_levels += range.rate;
    found.by_level.push_back(range);
  }
  for (RateInRange& range : found.by_level) {
    range.share = found.value > 0.0 ? range.rate / found.value : 0.0;
    if (!range.is_tested) found.untested_share += range.share;
  }
  return found;
}

LognormalCapacity capacity_of(const stats::LognormalFragility& law) {
  return {.centre = law.centre - law.intercept / law.slope, .dispersion = 1.0 / law.slope};
}

LognormalCapacity capacity_of(const stats::SuiteLaw& law) {
  return {.centre = std::log(law.median), .dispersion = law.dispersion()};
}

AnnualRate rate_by_law(const FragilityCurve& curve, const Counted& counted) {
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

AnnualRate rate_by_levels(const FragilityCurve& curve, const Counted& counted) {
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

std::string_view to_string(RateSource source) { return source == RateSource::law ? "law" : "levels"; }

AnnualRate annual_rate(const FragilityCurve& curve, const HazardCurve& hazard) {
  ROCKING_EXPECT(!curve.levels.empty());
  const Counted what = counted(hazard, curve.levels, curve.subject.least_uplift);
  return curve.law ? rate_by_law(curve, what) : rate_by_levels(curve, what);
}

std::optional<AnnualRate> annual_rate(const SuiteCurve& curve, const HazardCurve& hazard) {
  if (!curve.pooled) return std::nullopt;
  const Counted what = counted(hazard, curve.levels, curve.subject.least_uplift);
  AnnualRate found = disaggregated(what, capacity_of(curve.pooled->law()));
  const std::vector<HazardPiece> pieces = pieces_between(hazard, what.start);
  std::vector<double> rates;
  for (const stats::SuiteLaw& sample : curve.bootstrap.laws) rates.push_back(rate_of(capacity_of(sample), pieces));
  found.interval = stats::percentile_interval(std::move(rates), curve.bootstrap.samples, curve.subject.confidence);
  return found;
}

}  // namespace rocking
