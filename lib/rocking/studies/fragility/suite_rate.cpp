#include "rocking/studies/fragility/fragility.hpp"

#include <limits>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/record_shares.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "rocking/studies/fragility/counted_hazard.hpp"
#include "rocking/studies/fragility/rare_tail.hpp"
#include "rocking/studies/fragility/shares_and_hazard.hpp"

namespace rocking {
namespace {

LognormalCapacity capacity_of(const stats::SuiteLaw& law) {
  return {.centre = std::log(law.median), .dispersion = law.dispersion()};
}

stats::SuiteLevels levels_of(const std::vector<RecordCurve>& records) {
  stats::SuiteLevels suite;
  for (const RecordCurve& record : records) {
    auto& levels = suite.emplace_back();
    for (const FragilityLevel& level : record.curve.levels)
      levels.push_back({level.intensity, level.overturned, level.unresolved});
  }
  return suite;
}

constexpr double rounding_of_rate = 1e-12;  ///< of a rate, relative

/// What is counted of a hazard curve; the rare estimates take the place of the levels below the end of the tail.
CountedHazard counted_with_tail(const HazardCurve& hazard, const SuiteCurve& curve, const SuiteTail& tail) {
  CountedHazard counted = counted_hazard(hazard, curve.levels, curve.subject.least_uplift);
  if (tail.estimates.empty()) return counted;
  std::erase_if(counted.levels,
                [&tail](double level) { return tail.end ? level < *tail.end : level <= *tail.reach(); });
  std::vector<double> levels;
  for (const RareLevel& level : tail.estimates) levels.push_back(level.intensity);
  levels.insert(levels.end(), counted.levels.begin(), counted.levels.end());
  counted.levels = std::move(levels);
  return counted;
}

/// From the lower end of one to the upper end of the other.
std::optional<stats::Interval> between(const std::optional<stats::Interval>& lows,
                                       const std::optional<stats::Interval>& highs) {
  if (!lows || !highs) return std::nullopt;
  return stats::Interval{.low = lows->low, .high = highs->high};
}

RateSource source_of(RateBasis basis, const SuiteCurve& curve) {
  const bool is_by_law =
      basis == RateBasis::law_if_fitted && curve.outcome == stats::FragilityOutcome::fitted && curve.pooled;
  return is_by_law ? RateSource::law : RateSource::isotonic;
}

/// The rates of one suite and one hazard curve.
class SuiteRates {
 public:
  SuiteRates(const SuiteCurve& curve, const HazardCurve& hazard)
      : curve_(curve),
        suite_(levels_of(curve.records)),
        shares_(suite_),
        most_shares_(suite_, stats::RecordShares::Unresolved::as_happened),
        tail_(curve),
        counted_(counted_with_tail(hazard, curve, tail_)),
        pieces_(counted_.pieces()),
        rates_(counted_, shares_.intensities().size(), tail_) {}

  /// By isotonic shares, of records with these weights.
  [[nodiscard]] double rate_by_shares(const std::vector<double>& weights) const {
    return rates_.rate(isotonic(shares_, weights));
  }

  /// Of bootstrap sample i, by the law or by isotonic shares, in which trials without an answer may have the event; absent
  /// where the sample has no law.
  [[nodiscard]] std::optional<AllowedRate> allowed_in_sample(RateSource source, std::size_t i) const {
    const stats::RecordBootstrap& bootstrap = curve_.bootstrap;
    const std::vector<double>& weights = bootstrap.weights[i];
    if (source == RateSource::law) {
      const auto place = std::ranges::lower_bound(bootstrap.samples_with_law, i);
      if (place == bootstrap.samples_with_law.end() || *place != i) return std::nullopt;
      const double rate = rate_of(
          by_law_of(bootstrap.laws[static_cast<std::size_t>(place - bootstrap.samples_with_law.begin())], weights),
          pieces_);
      return AllowedRate{.linear = {rate, rate}, .lognormal = {rate, rate}};
    }
    return allowed(weights);
  }
  /// By the law or by isotonic shares: the rate of the suite with its interval.
  [[nodiscard]] RateEstimate estimate_of(RateSource source) const {
    return source == RateSource::law ? by_law() : by_shares();
  }
  /// Whether the shares of bootstrap samples give different rates.
  [[nodiscard]] bool scatters() const {
    if (curve_.bootstrap.weights.empty()) return false;
    const double first = rate_by_shares(curve_.bootstrap.weights.front());
    return std::ranges::any_of(curve_.bootstrap.weights, [&](const auto& weights) {
      return std::abs(rate_by_shares(weights) - first) > rounding_of_rate * first;
    });
  }

  [[nodiscard]] SuiteRate all(RateBasis basis) const {
    SuiteRate found;
    if (curve_.pooled) found.estimates.push_back(by_law());
    found.estimates.push_back(by_shares());
    const bool is_by_law = source_of(basis, curve_) == RateSource::law;
    found.chosen = is_by_law ? disaggregated(counted_, by_law_of(curve_.pooled->law(), equal_weights()))
                             : disaggregated(counted_, rates_.probability(isotonic(shares_, equal_weights())));
    found.chosen.source = is_by_law ? RateSource::law : RateSource::isotonic;
    found.chosen.rare_below = tail_.reach();
    found.chosen.rare_use = tail_.use;
    if (curve_.pooled) found.chosen.impossible = impossible();
    for (const RateEstimate& estimate : found.estimates) {
      if (estimate.source == found.chosen.source) found.chosen.interval = estimate.interval;
    }
    set_disagreement(found);
    set_records(found);
    set_undecided(found);
    found.at_most = is_by_law ? most_by_law() : allowed(equal_weights()).high();
    return found;
  }

 private:
  /// Half of one trial over all trials of a level.
  [[nodiscard]] double half_trial() const {
    std::uint64_t trials = 0;
    for (const auto& record : suite_) trials += record.front().happened.trials;
    return 0.5 / static_cast<double>(trials);
  }
  [[nodiscard]] std::vector<double> equal_weights() const { return std::vector<double>(suite_.size(), 1.0); }
  /// Of records with these weights, whose law it is.
  [[nodiscard]] WithTail<LognormalCapacity> by_law_of(const stats::SuiteLaw& law,
                                                      const std::vector<double>& weights) const {
    return {tail_.y, tail_.means(weights), capacity_of(law)};
  }

  [[nodiscard]] double impossible() const {
    return rate_of(by_law_of(curve_.pooled->law(), equal_weights()),
                   pieces_between(counted_.hazard, counted_.first, counted_.start));
  }

  [[nodiscard]] RateEstimate by_law() const {
    std::vector<double> samples;
    for (const std::size_t i : curve_.bootstrap.samples_with_law) {
      samples.push_back(allowed_in_sample(RateSource::law, i).value().linear.low);
    }
    return {RateSource::law, rate_of(by_law_of(curve_.pooled->law(), equal_weights()), pieces_),
            curve_.interval_of(std::move(samples))};
  }
  /// The largest rate that the levels allow of a probability that is the law's between them.
  [[nodiscard]] double most_by_law() const {
    const auto law = by_law_of(curve_.pooled->law(), equal_weights());
    return rates_.allowed_outside(law, rate_of(law, pieces_), isotonic(shares_, equal_weights())).high;
  }

  /// Isotonic shares of records with these weights, at the levels that count.
  [[nodiscard]] std::vector<double> isotonic(const stats::RecordShares& of, const std::vector<double>& weights) const {
    return rates_.counted_of(of.isotonic(weights), tail_.means(weights));
  }
  /// By isotonic shares of records with these weights; trials without an answer have the event at most.
  [[nodiscard]] AllowedRate allowed(const std::vector<double>& weights) const {
    const auto of = [&](const stats::RecordShares& shares) {
      return rates_.allowed(isotonic(shares, weights), half_trial());
    };
    AllowedRate found = of(shares_);
    const AllowedRate most = of(most_shares_);
    found.linear.high = most.linear.high;
    found.lognormal.high = most.lognormal.high;
    return found;
  }

  [[nodiscard]] std::vector<double> counted_of_record(const stats::RecordShares& of, std::size_t record) const {
    return rates_.counted_of(of.of_record(record), tail_.of_records[record]);
  }

  [[nodiscard]] RateEstimate by_shares() const {
    std::vector<std::vector<double>> of_records;
    for (std::size_t r = 0; r < suite_.size(); ++r) of_records.push_back(counted_of_record(most_shares_, r));
    const std::vector<double> worst = rates_.worst_unseen(of_records);
    auto interval = interval_with_unseen(worst);
    // Records that are all alike say nothing of how much another one may differ.
    if (interval && interval->high - interval->low <= rounding_of_rate * interval->high) {
      interval = interval_with_unseen(std::vector<double>(worst.size(), 1.0));
    }
    return {RateSource::isotonic, rate_by_shares(equal_weights()), interval};
  }

  /// From the least rate that the levels allow, with an unseen record that never overturns, to the largest one, with one
  /// that does so as in `worst`. Trials without an answer have the event at the upper end.
  [[nodiscard]] std::optional<stats::Interval> interval_with_unseen(const std::vector<double>& worst) const {
    const std::vector<double> best(worst.size(), 0.0);
    std::vector<double> lows, highs;
    for (std::vector<double> weights : curve_.bootstrap.with_unseen) {
      const double unseen = weights.back();
      weights.pop_back();
      std::vector<double> parts = shares_of_unseen(weights, unseen);
      const auto low = stats::mean_with_unseen(isotonic(shares_, weights), parts, best);
      const auto high = stats::mean_with_unseen(isotonic(most_shares_, weights), parts, worst);
      lows.push_back(rates_.least_allowed(low));
      highs.push_back(rates_.most_allowed(high));
    }
    const double confidence = curve_.subject.confidence;
    return between(stats::percentile_interval(std::move(lows), curve_.bootstrap.samples, confidence),
                   stats::percentile_interval(std::move(highs), curve_.bootstrap.samples, confidence));
  }

  /// In the means at the points that count: of a level with records of its own, among these.
  [[nodiscard]] std::vector<double> shares_of_unseen(const std::vector<double>& weights, double unseen) const {
    std::vector<double> at_levels = shares_.shares_of_another(weights, unseen);
    const std::size_t points = rates_.counted_of(at_levels, tail_.means(weights)).size();
    at_levels.erase(at_levels.begin(),
                    at_levels.end() - static_cast<std::ptrdiff_t>(std::min(points, at_levels.size())));
    at_levels.insert(at_levels.begin(), points - at_levels.size(), unseen);
    return at_levels;
  }

  static void set_disagreement(SuiteRate& found) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const RateEstimate& estimate : found.estimates) {
      least = std::min(least, estimate.value);
      most = std::max(most, estimate.value);
    }
    if (least > 0.0) found.disagreement = most / least - 1.0;
    if (most == 0.0) found.disagreement = 0.0;
  }

  /// The mean over the records is the rate of their mean shares. A range of the tail is shared out by the mean of the shares that a
  /// record has in the probabilities at its two ends.
  [[nodiscard]] double rate_of_record(std::size_t record) const {
    const std::vector<double> own = counted_of_record(shares_, record);
    if (tail_.estimates.empty()) return rates_.rate(own);
    const std::vector<double> means = rates_.counted_of(shares_.mean(equal_weights()), tail_.means(equal_weights()));
    const auto of_all = rates_.probability(means);
    double rate = rate_of(rates_.probability(own), pieces_within(pieces_, tail_.y.back(), HUGE_VAL));
    for (std::size_t i = 0; i + 1 < tail_.y.size(); ++i) {
      const double low = i == 0 ? -HUGE_VAL : tail_.y[i];
      const double share = 0.5 * (own[i] / means[i] + own[i + 1] / means[i + 1]);
      rate += share * rate_of(of_all, pieces_within(pieces_, low, tail_.y[i + 1]));
    }
    return rate;
  }

  void set_records(SuiteRate& found) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < suite_.size(); ++r) {
      found.by_record.push_back({.name = curve_.records[r].name, .rate = rate_of_record(r)});
      sum += found.by_record.back().rate;
    }
    for (RateOfRecord& record : found.by_record) record.share = sum > 0.0 ? record.rate / sum : 0.0;
  }

  void set_undecided(SuiteRate& found) const {
    const std::vector<double> shares = isotonic(shares_, equal_weights());
    const std::vector<LevelShare> levels = rates_.levels(shares, half_trial());
    const double rate = rates_.rate(shares);
    double open = 0.0;
    for (const UndecidedRange& range : undecided_ranges(levels, counted_.hazard, counted_.start)) open += range.rate;
    open += rates_.rate(isotonic(most_shares_, equal_weights())) - rate;  // without an answer
    found.undecided_share = rate > 0.0 ? open / rate : (open > 0.0 ? 1.0 : 0.0);
    const auto between = rates_.probability(shares);
    found.add_levels =
        levels_to_add(levels, counted_.hazard, counted_.start, most_undecided_share * rate, [&](double intensity) {
          if (curve_.pooled) {
            return by_law_of(curve_.pooled->law(), equal_weights()).probability(std::log(intensity));
          }
          return intensity > levels.back().intensity ? 0.5 * (1.0 + shares.back())
                                                     : between.probability(std::log(intensity));
        });
    if (!found.do_estimates_agree() && found.add_levels.empty())
      found.add_levels.push_back(where_law_differs_most(found));
  }

  /// Inside the range whose rates by the law and by the isotonic shares differ most.
  [[nodiscard]] double where_law_differs_most(const SuiteRate& found) const {
    const auto of_shares = rates_.probability(isotonic(shares_, equal_weights()));
    double most = -1.0, at = counted_.start;
    for (const RateInRange& range : found.chosen.by_level) {
      const std::vector<HazardPiece> pieces = pieces_between(counted_.hazard, range.from, range.to);
      const double law = curve_.pooled ? rate_of(by_law_of(curve_.pooled->law(), equal_weights()), pieces) : 0.0;
      const double difference = std::abs(law - rate_of(of_shares, pieces));
      if (difference <= most) continue;
      most = difference;
      at = inside(range.from, range.to);
    }
    return at;
  }

  const SuiteCurve& curve_;
  stats::SuiteLevels suite_;
  stats::RecordShares shares_;       ///< trials without an answer did not have the event
  stats::RecordShares most_shares_;  ///< they had it
  SuiteTail tail_;
  CountedHazard counted_;
  std::vector<HazardPiece> pieces_;
  SharesAndHazard rates_;
};

}  // namespace

RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard,
                              RateBasis basis) {
  ROCKING_EXPECT(base.records.size() == option.records.size());
  const SuiteRates of_base(base, hazard), of_option(option, hazard);
  RateComparison found{.base = base.subject.others, .option = option.subject.others, .event = option.subject.event};
  const bool have_law = source_of(basis, base) == RateSource::law && source_of(basis, option) == RateSource::law;
  found.source = have_law ? RateSource::law : RateSource::isotonic;
  const RateEstimate of_first = of_base.estimate_of(found.source), of_second = of_option.estimate_of(found.source);
  const double before = of_first.value, after = of_second.value;
  found.difference = after - before;
  if (before > 0.0) found.ratio = after / before;
  std::vector<double> low_differences, high_differences, low_ratios, high_ratios;
  const auto ratio_of = [](double part, double whole) {
    return whole > 0.0 ? part / whole : std::numeric_limits<double>::infinity();
  };
  // The curve between the levels is the same one in both.
  const auto compare = [&](const AllowedRate& first, const AllowedRate& second) {
    const auto& [a, b] = first;
    const auto& [c, d] = second;
    low_differences.push_back(std::min(c.low - a.high, d.low - b.high));
    high_differences.push_back(std::max(c.high - a.low, d.high - b.low));
    low_ratios.push_back(first.high() > 0.0 ? std::min(ratio_of(c.low, a.high), ratio_of(d.low, b.high)) : 0.0);
    high_ratios.push_back(std::max(ratio_of(c.high, a.low), ratio_of(d.high, b.low)));
  };
  // Where the samples of one do not scatter, its own interval says more than they do.
  const bool have_samples = of_base.scatters() && of_option.scatters();
  for (std::size_t i = 0; i < base.bootstrap.weights.size(); ++i) {
    const auto first = of_base.allowed_in_sample(found.source, i);
    const auto second = of_option.allowed_in_sample(found.source, i);
    if (have_samples && first && second) compare(*first, *second);
    if (!have_samples && of_first.interval && of_second.interval) {
      compare({*of_first.interval, *of_first.interval}, {*of_second.interval, *of_second.interval});
    }
  }
  const auto interval_of = [&base](std::vector<double> lows, std::vector<double> highs) {
    return between(base.interval_of(std::move(lows)), base.interval_of(std::move(highs)));
  };
  found.interval = interval_of(std::move(low_differences), std::move(high_differences));
  if (found.ratio) found.ratio_interval = interval_of(std::move(low_ratios), std::move(high_ratios));
  return found;
}

SuiteRate annual_rate(const SuiteCurve& curve, const HazardCurve& hazard, RateBasis basis) {
  ROCKING_EXPECT(!curve.records.empty() && !curve.levels.empty());
  return SuiteRates(curve, hazard).all(basis);
}

}  // namespace rocking
