#include "rocking/studies/curves/curves.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/stats/lack_of_fit.hpp"
#include "rocking/stats/mean_share.hpp"
#include "rocking/stats/record_shares.hpp"

namespace rocking {
namespace {

FragilityLevel estimated(const stats::IntensityLevel& data, const FragilityCurve& curve, std::size_t levels) {
  FragilityLevel level;
  level.intensity = data.intensity;
  level.overturned = stats::proportion_at(data);
  level.estimate = static_cast<double>(level.overturned.successes) / static_cast<double>(level.overturned.trials);
  const double confidence = curve.subject.confidence;
  level.unresolved = data.unresolved;
  const stats::CountBounds bounds = stats::bounds_of(level.overturned, level.unresolved);
  level.exact = stats::covering(
      bounds, [&](const stats::Proportion& counted) { return stats::clopper_pearson(counted, confidence); });
  level.simultaneous = stats::covering(bounds, [&](const stats::Proportion& counted) {
    return stats::bonferroni_clopper_pearson(counted, confidence, levels);
  });
  if (!curve.law) return level;
  level.fitted = curve.law->function.probability(level.intensity);
  level.band = curve.law->function.band(level.intensity, confidence);
  return level;
}

stats::BootstrapNumbers bootstrap_numbers(std::uint64_t seed) {
  return [seed](std::uint64_t sample, std::uint64_t number) {
    const random::Draws draws(seed, sample);
    return std::array{draws.uniform(random::Source::fragility_bootstrap, 2 * number),
                      draws.uniform(random::Source::fragility_bootstrap, 2 * number + 1)};
  };
}

void reject(FragilityCurve& curve, stats::FragilityOutcome outcome) {
  curve.outcome = outcome;
  curve.law.reset();
}

/// Fits the function, at the confidence of the curve.
void fit(const std::vector<stats::IntensityLevel>& levels, FragilityCurve& curve) {
  const double confidence = curve.subject.confidence;
  const stats::FragilityFit fit = stats::fit_lognormal(levels, confidence);
  curve.outcome = fit.outcome;
  if (!fit.law) return;
  const stats::Bounded median = fit.law->median(confidence);
  curve.law = {.function = *fit.law,
               .median = median,
               .is_extrapolated = median.value < levels.front().intensity || levels.back().intensity < median.value,
               .dispersion = fit.law->dispersion(confidence)};
}

/// Tests the fitted function, and removes it if it is rejected.
void test_fit(const std::vector<stats::IntensityLevel>& levels, std::uint64_t seed, const base::ManyParts& how,
              FragilityCurve& curve) {
  if (!curve.law) return;
  curve.test = stats::lack_of_fit(levels, curve.law->function, fragility_samples, bootstrap_numbers(seed), how);
  std::vector<stats::Proportion> counts;
  for (const stats::IntensityLevel& level : levels) counts.push_back(stats::proportion_at(level));
  if (!stats::isotonic_band(counts, curve.subject.confidence)) {
    reject(curve, stats::FragilityOutcome::not_monotone);
  } else if (curve.test->p_value <= fragility_significance) {
    reject(curve, stats::FragilityOutcome::rejected);
  }
}

/// Gives the levels of a curve whose function was rejected their isotonic estimates. Where pooling moves an estimate
/// out of the intervals of probabilities that do not decrease, the nearest end is the estimate.
void set_isotonic(FragilityCurve& curve) {
  if (curve.outcome != stats::FragilityOutcome::rejected) return;
  std::vector<stats::Proportion> counts;
  for (const FragilityLevel& level : curve.levels) counts.push_back(level.overturned);
  const std::vector<double> values = stats::isotonic_regression(counts);
  const std::vector<stats::Interval> band = stats::isotonic_band(counts, curve.subject.confidence).value();
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.levels[i].isotonic = std::clamp(values[i], band[i].low, band[i].high);
    curve.levels[i].band = curve.levels[i].simultaneous;
  }
}

}  // namespace

bool FragilityLevel::is_missed() const { return fitted && (*fitted < simultaneous.low || *fitted > simultaneous.high); }

std::size_t FragilityCurve::missed_levels() const {
  return static_cast<std::size_t>(std::ranges::count_if(levels, &FragilityLevel::is_missed));
}

FragilityCurve fragility_curve(const std::vector<stats::IntensityLevel>& levels, double confidence, std::uint64_t seed,
                               const base::ManyParts& how) {
  FragilityCurve curve;
  curve.subject.confidence = confidence;
  fit(levels, curve);
  test_fit(levels, seed, how, curve);
  for (const stats::IntensityLevel& level : levels) curve.levels.push_back(estimated(level, curve, levels.size()));
  set_isotonic(curve);
  return curve;
}

FragilityCurve fragility(const StripeGroup& group, const ResponseEvent& event, std::uint64_t seed,
                         const base::ManyParts& how) {
  ROCKING_EXPECT(!group.is_suite());
  std::vector<stats::IntensityLevel> levels;
  for (const Stripe& stripe : group.stripes) levels.push_back(level_of(stripe, event));
  FragilityCurve curve = fragility_curve(levels, group.confidence, seed, how);
  curve.subject = subject_of(group, event);
  for (std::size_t i = 0; i < curve.levels.size(); ++i) curve.levels[i].shaking = group.stripes[i].shaking;
  return curve;
}

}  // namespace rocking
