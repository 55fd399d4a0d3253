#include <limits>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/studies/fragility/suite_rates.hpp"

namespace rocking {
namespace {

/// The rate of a suite, and what its bootstrap samples allow; absent of a sample without a law.
struct SampledRate {
  RateEstimate whole;
  std::vector<std::optional<AllowedRate>> samples;
  bool scatters = false;
};

SampledRate sampled_rate(const SuiteCurve& curve, const HazardCurve& hazard, RateSource source) {
  const CountedSuite suite(curve, hazard);
  const ShareRates by_shares(suite);
  const stats::RecordBootstrap& bootstrap = curve.bootstrap;
  SampledRate found{.whole = {}, .samples = {}, .scatters = by_shares.scatters()};
  if (source == RateSource::law) {
    const LawRates by_law(suite);
    found.whole = by_law.estimate();
    found.samples.resize(bootstrap.weights.size());
    const std::vector<double> rates = by_law.of_samples();
    for (std::size_t k = 0; k < rates.size(); ++k) {
      const stats::Interval rate{.low = rates[k], .high = rates[k]};
      found.samples[bootstrap.samples_with_law[k]] = {.linear = rate, .lognormal = rate};
    }
  } else {
    found.whole = by_shares.estimate();
    for (const std::vector<double>& weights : bootstrap.weights) found.samples.emplace_back(by_shares.allowed(weights));
  }
  return found;
}

/// Its own interval in place of samples that do not scatter: it says more than they do.
void use_interval(SampledRate& rate) {
  std::optional<AllowedRate> all;
  if (rate.whole.interval) all = {.linear = *rate.whole.interval, .lognormal = *rate.whole.interval};
  std::ranges::fill(rate.samples, all);
}

double ratio_of(double part, double whole) {
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::infinity();
}

}  // namespace

RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard,
                              RateBasis basis) {
  ROCKING_EXPECT(base.records.size() == option.records.size());
  RateComparison found{.base = base.subject.others, .option = option.subject.others, .event = option.subject.event};
  const bool have_law = basis == RateBasis::law_if_fitted && base.has_law() && option.has_law();
  found.source = have_law ? RateSource::law : RateSource::isotonic;
  SampledRate before = sampled_rate(base, hazard, found.source), after = sampled_rate(option, hazard, found.source);
  found.difference = after.whole.value - before.whole.value;
  if (before.whole.value > 0.0) found.ratio = after.whole.value / before.whole.value;
  if (!before.scatters || !after.scatters) {
    use_interval(before);
    use_interval(after);
  }
  std::vector<double> low_differences, high_differences, low_ratios, high_ratios;
  for (std::size_t i = 0; i < before.samples.size(); ++i) {
    if (!before.samples[i] || !after.samples[i]) continue;
    // The curve between the levels is the same one in both.
    const auto& [a, b] = *before.samples[i];
    const auto& [c, d] = *after.samples[i];
    low_differences.push_back(std::min(c.low - a.high, d.low - b.high));
    high_differences.push_back(std::max(c.high - a.low, d.high - b.low));
    const bool may_happen = before.samples[i]->high() > 0.0;
    low_ratios.push_back(may_happen ? std::min(ratio_of(c.low, a.high), ratio_of(d.low, b.high)) : 0.0);
    high_ratios.push_back(std::max(ratio_of(c.high, a.low), ratio_of(d.high, b.low)));
  }
  const auto interval_of = [&base](std::vector<double> lows, std::vector<double> highs) {
    return between(base.interval_of(std::move(lows)), base.interval_of(std::move(highs)));
  };
  found.interval = interval_of(std::move(low_differences), std::move(high_differences));
  if (found.ratio) found.ratio_interval = interval_of(std::move(low_ratios), std::move(high_ratios));
  return found;
}

}  // namespace rocking
