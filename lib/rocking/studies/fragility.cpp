#include "rocking/studies/fragility.hpp"

#include <algorithm>
#include <array>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/stats/isotonic.hpp"

namespace rocking {
namespace {

FragilityLevel estimated(const stats::IntensityLevel& data, const FragilityCurve& curve, std::size_t levels) {
  FragilityLevel level;
  level.intensity = data.intensity;
  level.overturned = stats::proportion_at(data);
  level.estimate = static_cast<double>(level.overturned.successes) / static_cast<double>(level.overturned.trials);
  level.exact = stats::clopper_pearson(level.overturned, curve.confidence);
  level.simultaneous = stats::bonferroni_clopper_pearson(level.overturned, curve.confidence, levels);
  if (!curve.fit.law) return level;
  FittedProbability& fitted = level.fitted.emplace();
  fitted.value = curve.fit.law->probability(level.intensity);
  fitted.band = curve.fit.law->band(level.intensity, curve.confidence);
  fitted.is_missed = fitted.value < level.simultaneous.low || fitted.value > level.simultaneous.high;
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
  curve.fit = {.outcome = outcome, .law = std::nullopt};
}

/// Tests the fitted function, and removes it if it is rejected.
void test_fit(const std::vector<stats::IntensityLevel>& levels, std::uint64_t seed, const base::ManyParts& how,
              FragilityCurve& curve) {
  if (!curve.fit.law) return;
  curve.test = stats::lack_of_fit(levels, *curve.fit.law, fragility_samples, bootstrap_numbers(seed), how);
  std::vector<stats::Proportion> counts;
  for (const stats::IntensityLevel& level : levels) counts.push_back(stats::proportion_at(level));
  if (!stats::isotonic_band(counts, curve.confidence)) {
    reject(curve, stats::FragilityOutcome::not_monotone);
  } else if (curve.test->p_value <= fragility_significance) {
    reject(curve, stats::FragilityOutcome::rejected);
  }
}

/// Gives the levels of a curve whose function was rejected their isotonic estimates. Where pooling moves an estimate
/// out of the intervals of probabilities that do not decrease, the nearest end is the estimate.
void set_isotonic(FragilityCurve& curve) {
  if (curve.fit.outcome != stats::FragilityOutcome::rejected) return;
  std::vector<stats::Proportion> counts;
  for (const FragilityLevel& level : curve.levels) counts.push_back(level.overturned);
  const std::vector<double> values = stats::isotonic_regression(counts);
  const std::vector<stats::Interval> band = stats::isotonic_band(counts, curve.confidence).value();
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.levels[i].isotonic = std::clamp(values[i], band[i].low, band[i].high);
  }
}

}  // namespace

std::size_t FragilityCurve::missed_levels() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      levels, [](const FragilityLevel& level) { return level.fitted && level.fitted->is_missed; }));
}

bool FragilityCurve::is_extrapolated(double intensity) const {
  return intensity < levels.front().intensity || levels.back().intensity < intensity;
}

FragilityCurve fragility_curve(const std::vector<stats::IntensityLevel>& levels, double confidence, std::uint64_t seed,
                               const base::ManyParts& how) {
  FragilityCurve curve;
  curve.confidence = confidence;
  curve.fit = stats::fit_lognormal(levels, confidence);
  test_fit(levels, seed, how, curve);
  for (const stats::IntensityLevel& level : levels) curve.levels.push_back(estimated(level, curve, levels.size()));
  set_isotonic(curve);
  return curve;
}

FragilityCurve fragility(const StripeGroup& group, const FragilityEvent& event, std::uint64_t seed,
                         const base::ManyParts& how) {
  ROCKING_EXPECT(!group.is_suite());
  std::vector<stats::IntensityLevel> levels;
  for (const Stripe& stripe : group.stripes) levels.push_back(level_of(stripe, event));
  FragilityCurve curve = fragility_curve(levels, group.confidence, seed, how);
  curve.parameter = group.parameter;
  curve.others = group.others;
  curve.event = event;
  curve.least_uplift = group.least_uplift();
  return curve;
}

}  // namespace rocking
