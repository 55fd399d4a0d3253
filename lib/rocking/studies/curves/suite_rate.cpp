#include <limits>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/studies/curves/suite_rates.hpp"

namespace rocking {
namespace {

/// Larger over smaller, less 1; 0 without a law, or where both are 0.
std::optional<double> disagreement_of(const std::vector<RateEstimate>& estimates) {
  const auto [least, most] = std::minmax(estimates.front().value, estimates.back().value);
  if (most == 0.0) return 0.0;
  return least > 0.0 ? std::optional(most / least - 1.0) : std::nullopt;
}

std::vector<RateOfRecord> by_record(const SuiteCurve& curve, const ShareRates& by_shares) {
  std::vector<RateOfRecord> records;
  double sum = 0.0;
  for (std::size_t r = 0; r < curve.records.size(); ++r) {
    records.push_back({.name = curve.records[r].name, .rate = by_shares.of_record(r)});
    sum += records.back().rate;
  }
  for (RateOfRecord& record : records) record.share = sum > 0.0 ? record.rate / sum : 0.0;
  return records;
}

/// Inside the range whose rates by the law and by the isotonic shares differ most.
double where_law_differs_most(const std::vector<RateInRange>& ranges, const LawRates& by_law,
                              const ShareRates& by_shares, const CountedHazard& counted) {
  double most = -1.0, at = counted.start;
  for (const RateInRange& range : ranges) {
    const std::vector<HazardPiece> pieces = pieces_between(counted.hazard, range.from, range.to);
    const double difference =
        std::abs(rate_of(by_law.probability(), pieces) - rate_of(by_shares.probability(), pieces));
    if (difference <= most) continue;
    most = difference;
    at = inside(range.from, range.to);
  }
  return at;
}

void set_undecided(const CountedHazard& counted, const std::optional<LawRates>& by_law, const ShareRates& by_shares,
                   SuiteRate& found) {
  const std::vector<LevelShare> levels = by_shares.levels();
  const double rate = by_shares.rate();
  double open = 0.0;
  for (const UndecidedRange& range : undecided_ranges(levels, counted.hazard, counted.start)) open += range.rate;
  open += by_shares.rate_without_answer();
  found.undecided_share = rate > 0.0 ? open / rate : (open > 0.0 ? 1.0 : 0.0);
  const auto between_levels = by_shares.probability();
  const auto expected = [&](double intensity) {
    if (by_law) return by_law->probability().probability(std::log(intensity));
    return intensity > levels.back().intensity ? 0.5 * (1.0 + levels.back().share)
                                               : between_levels.probability(std::log(intensity));
  };
  found.add_levels = levels_to_add(levels, counted.hazard, counted.start, most_undecided_share * rate, expected);
  if (by_law && !found.do_estimates_agree() && found.add_levels.empty()) {
    found.add_levels.push_back(where_law_differs_most(found.chosen.by_level, *by_law, by_shares, counted));
  }
}

}  // namespace

SuiteRate annual_rate(const SuiteCurve& curve, const HazardCurve& hazard, RateSource source) {
  ROCKING_EXPECT(!curve.records.empty() && !curve.levels.empty());
  const CountedSuite suite(curve, hazard);
  const ShareRates by_shares(suite);
  const std::optional<LawRates> by_law = curve.pooled ? std::optional<LawRates>(suite) : std::nullopt;
  const bool is_by_law = source == RateSource::law && curve.has_law();
  SuiteRate found;
  if (by_law) found.estimates.push_back(by_law->estimate());
  found.estimates.push_back(by_shares.estimate());
  found.chosen = is_by_law ? disaggregated(suite.counted, by_law->probability())
                           : disaggregated(suite.counted, by_shares.probability());
  const RateEstimate& chosen = is_by_law ? found.estimates.front() : found.estimates.back();
  found.chosen.source = chosen.source;
  found.chosen.interval = chosen.interval;
  found.chosen.rare_below = suite.tail.reach();
  found.chosen.rare_use = suite.tail.use;
  if (by_law) {
    found.chosen.impossible =
        rate_of(by_law->probability(), pieces_between(hazard, suite.counted.first, suite.counted.start));
  }
  found.disagreement = disagreement_of(found.estimates);
  found.by_record = by_record(curve, by_shares);
  set_undecided(suite.counted, by_law, by_shares, found);
  found.at_most = is_by_law ? by_shares.most_of(by_law->probability(), by_law->rate())
                            : by_shares.allowed(suite.equal_weights()).high();
  return found;
}

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
                              RateSource source) {
  ROCKING_EXPECT(base.records.size() == option.records.size());
  RateComparison found{.base = base.subject.others, .option = option.subject.others, .event = option.subject.event};
  const bool have_law = source == RateSource::law && base.has_law() && option.has_law();
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
