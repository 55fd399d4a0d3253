#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/lack_of_fit.hpp"
#include "rocking/stats/mean_share.hpp"
#include "rocking/stats/record_shares.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "rocking/studies/curves/curves.hpp"

namespace rocking {
namespace {

/// First index of the draws of records; those below belong to the test of a fragility function.
constexpr std::uint64_t first_record_draw = std::uint64_t{1} << 62U;
/// First index of the draws of the test of a suite's law.
constexpr std::uint64_t first_test_draw = std::uint64_t{3} << 61U;

stats::RecordDraws draws_from(std::uint64_t seed, std::uint64_t first) {
  return [seed, first](std::uint64_t sample, std::uint64_t number) {
    return random::Draws(seed, sample).uniform(random::Source::fragility_bootstrap, first + number);
  };
}

template <class Value>
std::optional<stats::Interval> interval_of_samples(const SuiteCurve& curve, Value&& value) {
  std::vector<double> values;
  for (const stats::SuiteLaw& law : curve.bootstrap.laws) values.push_back(value(law));
  return curve.interval_of(std::move(values));
}

SuiteEstimate estimate_of(const stats::SuiteLevels& suite, const stats::SuiteLaw& law, stats::SuiteQuantity quantity,
                          const SuiteCurve& curve) {
  std::vector<double> samples;
  for (const stats::SuiteLaw& sample : curve.bootstrap.laws) samples.push_back(value_of(quantity, sample));
  return {.value = value_of(quantity, law),
          .interval = profile_interval(suite, law, quantity, curve.subject.confidence),
          .bootstrap = curve.interval_about(value_of(quantity, law), std::move(samples))};
}

void set_pooled(const stats::SuiteLevels& suite, std::uint64_t seed, const base::ManyParts& how, SuiteCurve& curve) {
  const stats::SuiteFit fit = stats::fit_suite(suite);
  curve.outcome = fit.outcome;
  curve.bootstrap = stats::bootstrap_records(suite, suite_samples, draws_from(seed, first_record_draw), how);
  if (!fit.law) return;
  curve.test = stats::suite_lack_of_fit(suite, *fit.law, suite_samples, draws_from(seed, first_test_draw), how);
  if (curve.test && curve.test->p_value <= fragility_significance) curve.outcome = stats::FragilityOutcome::rejected;
  using enum stats::SuiteQuantity;
  constexpr std::array quantities{median, dispersion, between_records, within_record};
  std::array<SuiteEstimate, quantities.size()> found;
  base::for_each_part(how, quantities.size(),
                      [&](std::size_t i) { found[i] = estimate_of(suite, *fit.law, quantities[i], curve); });
  curve.pooled = PooledSuite{.median = found[0],
                             .dispersion = found[1],
                             .between_records = found[2],
                             .within_record = found[3],
                             .log_likelihood = fit.law->log_likelihood};
}

std::vector<SuiteLevel> pooled_levels(const stats::SuiteLevels& suite, const SuiteCurve& curve) {
  std::map<double, SuiteLevel> levels;
  for (const auto& record : suite) {
    for (const stats::RecordLevel& found : record) {
      SuiteLevel& level = levels[found.intensity];
      level.intensity = found.intensity;
      ++level.records;
      level.overturned.successes += found.happened.successes;
      level.overturned.trials += found.happened.trials;
      level.unresolved += found.unresolved;
      level.estimate += static_cast<double>(found.happened.successes) / static_cast<double>(found.happened.trials);
    }
  }
  std::vector<SuiteLevel> list;
  for (auto& [intensity, level] : levels) {
    level.estimate /= static_cast<double>(level.records);
    if (curve.pooled) {
      level.fitted = curve.pooled->law().probability(intensity);
      level.band =
          interval_of_samples(curve, [x = intensity](const stats::SuiteLaw& law) { return law.probability(x); });
    }
    list.push_back(level);
  }
  return list;
}

struct Banded {
  double value = 0.0;
  stats::Interval band;
};

/// Isotonic means of the shares of the records at the levels.
std::vector<Banded> isotonic_of(const stats::SuiteLevels& suite, stats::RecordShares::Unresolved unresolved,
                                const SuiteCurve& curve) {
  const stats::RecordShares shares(suite, unresolved);
  const std::vector<double> whole = shares.isotonic(std::vector<double>(suite.size(), 1.0));
  std::vector<std::vector<double>> samples(whole.size());
  for (const std::vector<double>& weights : curve.bootstrap.weights) {
    const std::vector<double> sample = shares.isotonic(weights);
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k].push_back(sample[k]);
  }
  std::vector<Banded> found;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    found.push_back({whole[k], curve.interval_of_share(whole[k], std::move(samples[k]))});
  }
  return found;
}

void set_isotonic(const stats::SuiteLevels& suite, SuiteCurve& curve) {
  using enum stats::RecordShares::Unresolved;
  const std::vector<Banded> least = isotonic_of(suite, as_not_happened, curve);
  const std::vector<Banded> most = isotonic_of(suite, as_happened, curve);
  for (std::size_t k = 0; k < least.size(); ++k) {
    curve.levels[k].isotonic = least[k].value;
    curve.levels[k].isotonic_band = {.low = least[k].band.low, .high = most[k].band.high};
  }
}

std::vector<RecordCurve> curves_of_records(const StripeGroup& group, const ResponseEvent& event, std::uint64_t seed,
                                           const base::ManyParts& how) {
  const std::vector<std::span<const Stripe>> records = group.by_record();
  std::vector<RecordCurve> curves(records.size());
  base::for_each_part(how, records.size(), [&](std::size_t r) {
    std::vector<stats::IntensityLevel> levels;
    for (const Stripe& stripe : records[r]) levels.push_back(level_of(stripe, event));
    FragilityCurve curve = fragility_curve(levels, group.confidence, seed, {.stop = how.stop});
    curve.subject = subject_of(group, event);
    curve.subject.least_uplift.reset();
    curves[r] = {.name = records[r].front().record, .curve = std::move(curve)};
  });
  return curves;
}

}  // namespace

double SuiteCurve::confidence_of_percentiles() const {
  return stats::expanded_confidence(subject.confidence, records_in_sample());
}

std::optional<stats::Interval> SuiteCurve::interval_of(std::vector<double> samples) const {
  return stats::percentile_interval(std::move(samples), bootstrap.samples, confidence_of_percentiles());
}

std::optional<stats::Interval> SuiteCurve::interval_about(double estimate, std::vector<double> samples) const {
  return stats::bias_corrected_interval(std::move(samples), estimate, bootstrap.samples, confidence_of_percentiles());
}

stats::Interval SuiteCurve::interval_of_share(double value, std::vector<double> samples) const {
  constexpr double rounding = 1e-12;
  const stats::Interval found = interval_of(std::move(samples)).value();
  if (found.high - found.low > rounding) return found;
  return stats::interval_of_equal_shares(value, records_in_sample(), subject.confidence);
}

stats::SuiteLaw PooledSuite::law() const {
  return {.median = median.value,
          .between_records = between_records.value,
          .within_record = within_record.value,
          .log_likelihood = log_likelihood};
}

std::uint64_t parts_of_suite_curve(const StripeGroup& group) {
  constexpr std::uint64_t quantities = 4;
  return 2 * suite_samples + quantities + group.by_record().size() + all_intensity_measures.size();
}

SuiteCurve suite_curve(const StripeGroup& group, const ResponseEvent& event, std::uint64_t seed,
                       const base::ManyParts& how) {
  ROCKING_EXPECT(group.is_suite());
  SuiteCurve curve;
  curve.subject = subject_of(group, event);
  const stats::SuiteLevels suite = levels_of_records(group.stripes, event);
  set_pooled(suite, seed, how, curve);
  curve.levels = pooled_levels(suite, curve);
  set_isotonic(suite, curve);
  if (curve.pooled) {
    const double median = curve.pooled->median.value;
    curve.pooled->is_extrapolated = median < curve.levels.front().intensity || curve.levels.back().intensity < median;
  }
  curve.records = curves_of_records(group, event, seed, how);
  curve.measures = ranked_measures(group.stripes, event, how);
  return curve;
}

namespace {

constexpr double parameters_of_a_law = 3.0;

void measure(const stats::SuiteLevels& suite, RankedMeasure& found) {
  const auto law = stats::fit_suite(suite).law;
  if (!law) return;
  found.median = law->median;
  found.dispersion = law->dispersion();
  found.between_records = law->between_records;
  found.within_record = law->within_record;
  found.deviance = -2.0 * law->log_likelihood;
  found.aic = *found.deviance + 2.0 * parameters_of_a_law;
}

}  // namespace

stats::SuiteLevels levels_of_records(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                     std::optional<IntensityMeasure> measure) {
  stats::SuiteLevels suite;
  std::map<std::string, std::size_t> places;
  for (const Stripe& stripe : stripes) {
    const auto [place, is_new] = places.try_emplace(stripe.record, suite.size());
    if (is_new) suite.emplace_back();
    const stats::IntensityLevel level = level_of(stripe, event);
    suite[place->second].push_back({.intensity = measure ? stripe.measure(*measure).value() : stripe.intensity,
                                    .happened = stats::proportion_at(level),
                                    .unresolved = level.unresolved});
  }
  return suite;
}

std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                           const base::ManyParts& how) {
  std::vector<RankedMeasure> ranked;
  for (const IntensityMeasure each : all_intensity_measures) {
    const bool has_measure = std::all_of(stripes.begin(), stripes.end(), [&](const Stripe& stripe) {
      return stripe.measure(each) && *stripe.measure(each) > 0.0;
    });
    if (has_measure) ranked.emplace_back().measure = each;
  }
  base::for_each_part(how, ranked.size(),
                      [&](std::size_t i) { measure(levels_of_records(stripes, event, ranked[i].measure), ranked[i]); });
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedMeasure& a, const RankedMeasure& b) {
    constexpr double last = std::numeric_limits<double>::infinity();
    // Measures that are proportional to each other have equal laws up to rounding; they keep their order.
    const auto key = [](const RankedMeasure& found) {
      return std::tuple(found.dispersion ? std::round(1e6 * *found.dispersion) : last,
                        std::round(1e3 * found.deviance.value_or(0.0)));
    };
    return key(a) < key(b);
  });
  return ranked;
}

}  // namespace rocking
