#include "rocking/studies/annual_rate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/student_law.hpp"

namespace rocking {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Exponent of the power law between a point of the hazard curve and the next: H falls as x^-k.
double hazard_exponent(const HazardCurve& hazard, std::size_t piece) {
  const HazardPoint& low = hazard.points[piece];
  const HazardPoint& high = hazard.points[piece + 1];
  return std::log(low.rate / high.rate) / std::log(high.intensity / low.intensity);
}

double rate_above(const HazardCurve& hazard, std::size_t piece, double intensity) {
  const HazardPoint& low = hazard.points[piece];
  return low.rate * std::pow(intensity / low.intensity, -hazard_exponent(hazard, piece));
}

/// Over a part of one piece of the hazard curve without kinks of P, in y = ln x: |dH| = k H dy. Beyond the last point
/// `high` may be infinite: then until H has fallen to exp(-40) of what it is at `low`.
double rate_on_piece(const HazardCurve& hazard, std::size_t piece, const ProbabilityFunction& probability, double low,
                     double high) {
  const double exponent = hazard_exponent(hazard, piece);
  const double first = std::log(low);
  const double last = std::isinf(high) ? first + 40.0 / exponent : std::log(high);
  const auto integrand = [&](double y) {
    const double x = std::exp(y);
    return probability(x) * exponent * rate_above(hazard, piece, x);
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, first, last, 12, 1e-10);
}

std::vector<double> places_between(std::vector<double> places, double from, double to) {
  places.push_back(from);
  places.push_back(to);
  std::erase_if(places, [&](double x) { return x < from || x > to; });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Ends of the ranges of a disaggregation: the first point of the hazard curve, and the levels above it.
std::vector<double> ends_of_ranges(const HazardCurve& hazard, const std::vector<double>& tested) {
  std::vector<double> ends{hazard.points.front().intensity};
  for (const double level : tested) {
    if (level > ends.back()) ends.push_back(level);
  }
  return ends;
}

/// Value and disaggregation.
AnnualRate disaggregated(const HazardCurve& hazard, const std::vector<double>& tested,
                         const ProbabilityFunction& probability, const std::vector<double>& breaks) {
  AnnualRate found;
  found.probability_at_first = probability(hazard.points.front().intensity);
  const std::vector<double> ends = ends_of_ranges(hazard, tested);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    RateInRange range;
    range.from = ends[i];
    if (i + 1 < ends.size()) range.to = ends[i + 1];
    range.rate = rate_between(hazard, probability, range.from, range.to, breaks);
    range.is_tested = range.from >= tested.front() && range.to.has_value();
    found.value += range.rate;
    found.by_level.push_back(range);
  }
  for (RateInRange& range : found.by_level) {
    range.share = found.value > 0.0 ? range.rate / found.value : 0.0;
    if (!range.is_tested) found.untested_share += range.share;
  }
  return found;
}

std::vector<double> tested_levels(const FragilityCurve& curve) {
  std::vector<double> tested;
  for (const FragilityLevel& level : curve.levels) tested.push_back(level.intensity);
  return tested;
}

double total_rate(const HazardCurve& hazard, const ProbabilityFunction& probability,
                  const std::vector<double>& breaks) {
  return rate_between(hazard, probability, hazard.points.front().intensity, std::nullopt, breaks);
}

/// Places where a steep lognormal function rises.
std::vector<double> rise_of(double median, double dispersion) {
  std::vector<double> places;
  for (const double z : {-6.0, -3.0, -1.0, 0.0, 1.0, 3.0, 6.0}) places.push_back(median * std::exp(z * dispersion));
  return places;
}

AnnualRate rate_by_law(const FragilityCurve& curve, const HazardCurve& hazard) {
  const stats::LognormalFragility& law = curve.fit.law.value();
  const auto rate_of = [&](const stats::LognormalFragility& other) {
    const double median = std::exp(other.centre - other.intercept / other.slope);
    return total_rate(
        hazard, [&other](double x) { return other.probability(x); }, rise_of(median, 1.0 / other.slope));
  };
  AnnualRate found = disaggregated(
      hazard, tested_levels(curve), [&law](double x) { return law.probability(x); },
      rise_of(std::exp(law.centre - law.intercept / law.slope), 1.0 / law.slope));
  // Derivatives of ln rate by (a, b), from central differences of a hundredth of a standard error.
  const auto derivative = [&](double stats::LognormalFragility::*parameter, double variance) {
    const double step = 0.01 * std::sqrt(variance);
    stats::LognormalFragility low = law;
    stats::LognormalFragility high = law;
    low.*parameter -= step;
    high.*parameter += step;
    return (std::log(rate_of(high)) - std::log(rate_of(low))) / (2.0 * step);
  };
  const double by_a = derivative(&stats::LognormalFragility::intercept, law.covariance.aa);
  const double by_b = derivative(&stats::LognormalFragility::slope, law.covariance.bb);
  const double variance =
      by_a * by_a * law.covariance.aa + 2.0 * by_a * by_b * law.covariance.ab + by_b * by_b * law.covariance.bb;
  const double reach = stats::two_sided_t_quantile(curve.confidence, law.degrees_of_freedom);
  const double factor = std::exp(reach * std::sqrt(std::max(0.0, variance)));
  found.interval = stats::Interval{.low = found.value / factor, .high = found.value * factor};
  return found;
}

/// A probability at each level, continued between them and beyond.
enum class Between : std::uint8_t { linear, last_known, next_known };

ProbabilityFunction through_levels(std::vector<double> x, std::vector<double> p, Between between) {
  return [x = std::move(x), p = std::move(p), between](double intensity) {
    const auto next = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), intensity) - x.begin());
    if (next == 0) return between == Between::last_known ? 0.0 : p.front();
    if (next == x.size()) return between == Between::next_known ? 1.0 : p.back();
    if (between == Between::last_known) return p[next - 1];
    if (between == Between::next_known) return p[next];
    const double share = std::log(intensity / x[next - 1]) / std::log(x[next] / x[next - 1]);
    return p[next - 1] + share * (p[next] - p[next - 1]);
  };
}

AnnualRate rate_by_levels(const FragilityCurve& curve, const HazardCurve& hazard) {
  const std::vector<double> tested = tested_levels(curve);
  std::vector<double> estimates, lows, highs;
  for (const FragilityLevel& level : curve.levels) {
    estimates.push_back(level.isotonic.value_or(level.estimate));
    // The lower ends hold also at stronger levels, and the upper ones at weaker levels.
    lows.push_back(std::max(lows.empty() ? 0.0 : lows.back(), level.simultaneous.low));
    highs.push_back(level.simultaneous.high);
  }
  for (std::size_t i = highs.size() - 1; i-- > 0;) highs[i] = std::min(highs[i], highs[i + 1]);
  AnnualRate found = disaggregated(hazard, tested, through_levels(tested, estimates, Between::linear), tested);
  found.source = RateSource::levels;
  found.interval =
      stats::Interval{.low = total_rate(hazard, through_levels(tested, lows, Between::last_known), tested),
                      .high = total_rate(hazard, through_levels(tested, highs, Between::next_known), tested)};
  return found;
}

}  // namespace

double rate_between(const HazardCurve& hazard, const ProbabilityFunction& probability, double from,
                    std::optional<double> to, const std::vector<double>& breaks) {
  ROCKING_EXPECT(hazard.points.size() > 1);
  double rate = 0.0;
  for (std::size_t piece = 0; piece + 1 < hazard.points.size(); ++piece) {
    const bool is_last = piece + 2 == hazard.points.size();
    const double low = std::max(from, hazard.points[piece].intensity);
    const double high = std::min(to.value_or(infinity), is_last ? infinity : hazard.points[piece + 1].intensity);
    if (!(low < high)) continue;
    const std::vector<double> places = places_between(breaks, low, high);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      rate += rate_on_piece(hazard, piece, probability, places[i], places[i + 1]);
    }
  }
  return rate;
}

AnnualRate annual_rate(const FragilityCurve& curve, const HazardCurve& hazard) {
  ROCKING_EXPECT(!curve.levels.empty());
  return curve.fit.law ? rate_by_law(curve, hazard) : rate_by_levels(curve, hazard);
}

std::optional<AnnualRate> annual_rate(const SuiteCurve& curve, const HazardCurve& hazard) {
  if (!curve.pooled) return std::nullopt;
  std::vector<double> tested;
  for (const SuiteLevel& level : curve.levels) tested.push_back(level.intensity);
  const stats::SuiteLaw& law = curve.pooled->law;
  const auto rise = [](const stats::SuiteLaw& of) { return rise_of(of.median, of.dispersion()); };
  AnnualRate found = disaggregated(
      hazard, tested, [&law](double x) { return law.probability(x); }, rise(law));
  std::vector<double> rates;
  for (const stats::SuiteLaw& sample : curve.bootstrap.laws) {
    rates.push_back(total_rate(
        hazard, [&sample](double x) { return sample.probability(x); }, rise(sample)));
  }
  found.interval = stats::percentile_interval(std::move(rates), curve.bootstrap.samples, curve.confidence);
  return found;
}

}  // namespace rocking
