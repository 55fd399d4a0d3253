#include "rocking/studies/suite/suite_rate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/record_shares.hpp"
#include "rocking/stats/student_law.hpp"
#include "rocking/stats/unseen_record.hpp"
#include "rocking/studies/counted_hazard.hpp"
#include "rocking/studies/rare_tail.hpp"
#include "rocking/studies/suite/suite_tail.hpp"
#include "rocking/studies/suite/undecided.hpp"

namespace rocking {
namespace {

LognormalCapacity capacity_of(const stats::SuiteLaw& law) {
  return {.centre = std::log(law.median), .dispersion = law.dispersion()};
}

stats::SuiteLevels levels_of(const std::vector<RecordCurve>& records) {
  stats::SuiteLevels suite;
  for (const RecordCurve& record : records) {
    auto& levels = suite.emplace_back();
    for (const FragilityLevel& level : record.curve.levels) levels.push_back({level.intensity, level.overturned});
  }
  return suite;
}

/// What is counted of a hazard curve; the rare estimates take the place of the levels below the end of the tail.
CountedHazard counted_with_tail(const HazardCurve& hazard, const SuiteCurve& curve, const SuiteTail& tail) {
  CountedHazard counted = counted_hazard(hazard, curve.levels, curve.subject.least_uplift);
  if (!tail.end()) return counted;
  std::erase_if(counted.levels, [&tail](double level) { return level < *tail.end(); });
  counted.levels.insert(counted.levels.begin(), tail.intensities().begin(), tail.intensities().end());
  return counted;
}

/// Rare estimates, and shares at the levels that can lift the block, as probabilities that are integrated over the
/// hazard.
class SharesAndHazard {
 public:
  SharesAndHazard(const CountedHazard& counted, const stats::RecordShares& shares, const SuiteTail& tail)
      : hazard_(counted.hazard),
        tail_(tail),
        start_(counted.start),
        least_uplift_(counted.least_uplift),
        pieces_(counted.pieces()) {
    const std::vector<double>& all = shares.intensities();
    skipped_ = all.size() - (counted.levels.size() - tail.size());
    // A suite without a level that lifts the block does not overturn up to there.
    intensities_ = counted.levels.empty() ? std::vector<double>{start_} : counted.levels;
    is_below_uplift_ = counted.levels.empty();
    for (std::size_t k = 0; k < intensities_.size(); ++k) {
      std::vector<double> unit(intensities_.size(), 0.0);
      unit[k] = 1.0;
      weights_.push_back(rate_of(known(unit), pieces_));
      ranges_.push_back(hazard_between(k == 0 ? start_ : intensities_[k - 1], intensities_[k]));
    }
    ranges_.push_back(hazard_between(intensities_.back(), std::nullopt));
  }

  /// The probabilities of the tail, and the shares without those of the levels below it or below the least uplift.
  [[nodiscard]] std::vector<double> counted_of(std::vector<double> shares, const std::vector<double>& tail) const {
    if (is_below_uplift_) return {0.0};
    shares.erase(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(skipped_));
    shares.insert(shares.begin(), tail.begin(), tail.end());
    return shares;
  }
  [[nodiscard]] WithTail<KnownProbabilities> probability(const std::vector<double>& counted) const {
    return {tail_.y(), {counted.begin(), counted.begin() + static_cast<std::ptrdiff_t>(tail_.size())}, known(counted)};
  }
  /// The rate of these probabilities; without a tail it is linear in them.
  [[nodiscard]] double rate(const std::vector<double>& shares) const {
    if (tail_.end()) return rate_of(probability(shares), pieces_);
    double sum = 0.0;
    for (std::size_t k = 0; k < weights_.size(); ++k) sum += weights_[k] * shares[k];
    return sum;
  }
  /// Without the ranges between levels before number `from`.
  [[nodiscard]] double at_least(const std::vector<double>& shares, std::size_t from = 1) const {
    double sum = shares.back() * ranges_.back();
    for (std::size_t k = from; k < shares.size(); ++k) {
      sum += std::min(shares[k - 1], shares[k]) * ranges_[k];
    }
    return sum;
  }
  [[nodiscard]] double at_most(const std::vector<double>& shares, std::size_t from = 1) const {
    double sum = shares.front() * ranges_.front() + ranges_.back();
    for (std::size_t k = from; k < shares.size(); ++k) {
      sum += std::max(shares[k - 1], shares[k]) * ranges_[k];
    }
    return sum;
  }
  /// The least and the largest rate that the levels allow; between rare estimates that of the lines.
  [[nodiscard]] double least_allowed(const std::vector<double>& shares) const {
    return in_tail(shares) + at_least(shares, tail_.size() + 1);
  }
  [[nodiscard]] double most_allowed(const std::vector<double>& shares) const {
    return in_tail(shares) + at_most(shares, tail_.size() + 1);
  }
  /// Of a record that is not in the suite, at worst: the largest probability of any record at up to twice the intensity,
  /// or at the next level; 1 where that lies above the levels.
  [[nodiscard]] std::vector<double> worst_unseen(const std::vector<std::vector<double>>& counted_of_records) const {
    std::vector<double> worst(intensities_.size(), 1.0);
    for (std::size_t k = 0; k + 1 < intensities_.size() && 2.0 * intensities_[k] <= intensities_.back(); ++k) {
      const auto beyond = std::ranges::upper_bound(intensities_, 2.0 * intensities_[k]);
      const std::size_t last =
          std::max<std::size_t>(static_cast<std::size_t>(beyond - intensities_.begin()) - 1, k + 1);
      worst[k] = 0.0;
      for (const std::vector<double>& record : counted_of_records) {
        worst[k] = std::max(worst[k],
                            *std::max_element(record.begin(), record.begin() + static_cast<std::ptrdiff_t>(last) + 1));
      }
    }
    return worst;
  }
  [[nodiscard]] std::vector<LevelShare> levels(const std::vector<double>& shares, double half_trial) const {
    std::vector<LevelShare> list;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      // A rare estimate is told from 0.
      const double least = k < tail_.size() ? std::min(half_trial, shares[k]) : half_trial;
      list.push_back({intensities_[k], shares[k], least});
    }
    return list;
  }

 private:
  [[nodiscard]] double in_tail(const std::vector<double>& shares) const {
    if (!tail_.end()) return 0.0;
    return rate_of(probability(shares), pieces_within(pieces_, tail_.y().front(), tail_.y().back()));
  }
  /// Linear in ln x; 0 at the least uplift where that is known, wherever the hazard begins, and beyond the levels as at
  /// the last one.
  [[nodiscard]] KnownProbabilities known(const std::vector<double>& shares) const {
    KnownProbabilities found;
    const bool has_zero = least_uplift_ && *least_uplift_ < intensities_.front();
    if (has_zero) found = {.y = {std::log(*least_uplift_)}, .probabilities = {0.0}};
    for (const double intensity : intensities_) found.y.push_back(std::log(intensity));
    found.probabilities.insert(found.probabilities.end(), shares.begin(), shares.end());
    return found;
  }
  [[nodiscard]] double hazard_between(double from, std::optional<double> to) const {
    const std::vector<HazardPiece> pieces = pieces_between(hazard_, std::max(from, start_), to);
    return rate_of(KnownProbabilities{.y = {0.0}, .probabilities = {1.0}}, pieces);
  }

  const HazardCurve& hazard_;
  const SuiteTail& tail_;
  double start_;
  std::optional<double>
      least_uplift_;  ///< also where the hazard begins above it, so that less hazard is no higher rate
  std::vector<HazardPiece> pieces_;
  bool is_below_uplift_ = false;
  std::size_t skipped_ = 0;
  std::vector<double> intensities_;
  std::vector<double> weights_;  ///< derivatives of the rate by the shares
  std::vector<double> ranges_;   ///< hazard from the start to the first level, between levels, and beyond the last
};

/// The rates of one suite and one hazard curve.
class SuiteRates {
 public:
  SuiteRates(const SuiteCurve& curve, const HazardCurve& hazard)
      : curve_(curve),
        suite_(levels_of(curve.records)),
        shares_(suite_),
        tail_(curve),
        counted_(counted_with_tail(hazard, curve, tail_)),
        pieces_(counted_.pieces()),
        rates_(counted_, shares_, tail_) {}

  /// By shares, of records with these weights.
  [[nodiscard]] double rate_by(RateSource source, const std::vector<double>& weights) const {
    const std::vector<double> shares = counted_shares(source, weights);
    if (source == RateSource::at_least) return rates_.at_least(shares);
    if (source == RateSource::at_most) return rates_.at_most(shares);
    return rates_.rate(shares);
  }

  [[nodiscard]] SuiteRate all() const {
    SuiteRate found;
    if (curve_.pooled) found.estimates.push_back(by_law());
    for (const RateSource source :
         {RateSource::isotonic, RateSource::observed, RateSource::at_least, RateSource::at_most}) {
      found.estimates.push_back(by_shares(source));
    }
    const bool is_by_law = curve_.outcome == stats::FragilityOutcome::fitted;
    found.chosen = is_by_law
                       ? disaggregated(counted_, by_law_of(curve_.pooled->law(), equal_weights()))
                       : disaggregated(counted_, rates_.probability(rates_.counted_of(shares_.isotonic(equal_weights()),
                                                                                      tail_.means(equal_weights()))));
    found.chosen.source = is_by_law ? RateSource::law : RateSource::isotonic;
    found.chosen.rare_below = tail_.end();
    if (curve_.pooled) found.chosen.impossible = impossible();
    for (const RateEstimate& estimate : found.estimates) {
      if (estimate.source == found.chosen.source) found.chosen.interval = estimate.interval;
    }
    set_disagreement(found);
    set_records(is_by_law, found);
    set_undecided(found);
    return found;
  }

 private:
  [[nodiscard]] std::vector<double> equal_weights() const { return std::vector<double>(suite_.size(), 1.0); }
  /// Of records with these weights, whose law it is.
  [[nodiscard]] WithTail<LognormalCapacity> by_law_of(const stats::SuiteLaw& law,
                                                      const std::vector<double>& weights) const {
    return {tail_.y(), tail_.means(weights), capacity_of(law)};
  }
  /// Of the observed shares.
  [[nodiscard]] std::vector<double> observed() const {
    return rates_.counted_of(shares_.mean(equal_weights()), tail_.means(equal_weights()));
  }

  [[nodiscard]] double impossible() const {
    return rate_of(by_law_of(curve_.pooled->law(), equal_weights()),
                   pieces_between(counted_.hazard, counted_.first, counted_.start));
  }

  [[nodiscard]] RateEstimate by_law() const {
    std::vector<double> samples;
    const stats::RecordBootstrap& bootstrap = curve_.bootstrap;
    for (std::size_t i = 0; i < bootstrap.laws.size(); ++i) {
      const std::vector<double>& weights = bootstrap.weights[bootstrap.samples_with_law[i]];
      samples.push_back(rate_of(by_law_of(bootstrap.laws[i], weights), pieces_));
    }
    return {RateSource::law, rate_of(by_law_of(curve_.pooled->law(), equal_weights()), pieces_),
            curve_.interval_of(std::move(samples))};
  }

  [[nodiscard]] std::vector<double> counted_shares(RateSource source, const std::vector<double>& weights) const {
    const bool is_isotonic = source == RateSource::isotonic;
    return rates_.counted_of(is_isotonic ? shares_.isotonic(weights) : shares_.mean(weights), tail_.means(weights));
  }

  [[nodiscard]] std::vector<double> counted_of_record(std::size_t record) const {
    return rates_.counted_of(shares_.of_record(record), tail_.of_record(record));
  }

  [[nodiscard]] RateEstimate by_shares(RateSource source) const {
    return {source, rate_by(source, equal_weights()), interval_by_shares(source)};
  }

  /// From the least rate that the levels allow, with an unseen record that never overturns, to the largest one, with one
  /// that does so at its worst; of a bound that bound itself.
  [[nodiscard]] std::optional<stats::Interval> interval_by_shares(RateSource source) const {
    std::vector<std::vector<double>> of_records;
    for (std::size_t r = 0; r < suite_.size(); ++r) of_records.push_back(counted_of_record(r));
    const std::vector<double> worst = rates_.worst_unseen(of_records);
    const std::vector<double> best(worst.size(), 0.0);
    std::vector<double> lows, highs;
    for (std::vector<double> weights : curve_.bootstrap.with_unseen) {
      const double unseen = weights.back();
      weights.pop_back();
      const std::vector<double> shares = counted_shares(source, weights);
      const std::vector<double> low = stats::mean_with_unseen(shares, unseen, best);
      const std::vector<double> high = stats::mean_with_unseen(shares, unseen, worst);
      lows.push_back(source == RateSource::at_least  ? rates_.at_least(low)
                     : source == RateSource::at_most ? rates_.at_most(low)
                                                     : rates_.least_allowed(low));
      highs.push_back(source == RateSource::at_least  ? rates_.at_least(high)
                      : source == RateSource::at_most ? rates_.at_most(high)
                                                      : rates_.most_allowed(high));
    }
    const double confidence = curve_.subject.confidence;
    const auto low = stats::percentile_interval(std::move(lows), curve_.bootstrap.samples, confidence);
    const auto high = stats::percentile_interval(std::move(highs), curve_.bootstrap.samples, confidence);
    if (!low || !high) return std::nullopt;
    return stats::Interval{.low = low->low, .high = high->high};
  }

  static void set_disagreement(SuiteRate& found) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const RateEstimate& estimate : found.estimates) {
      if (estimate.source == RateSource::at_least || estimate.source == RateSource::at_most) continue;
      least = std::min(least, estimate.value);
      most = std::max(most, estimate.value);
    }
    if (least > 0.0) found.disagreement = most / least - 1.0;
    if (most == 0.0) found.disagreement = 0.0;
  }

  /// The chosen rate of the suite without one record.
  [[nodiscard]] std::optional<double> without(std::size_t record, bool is_by_law) const {
    if (suite_.size() < 2) return std::nullopt;
    std::vector<double> weights = equal_weights();
    weights[record] = 0.0;
    if (!is_by_law) return rate_by(RateSource::isotonic, weights);
    stats::SuiteLevels others = suite_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(record));
    const auto law = stats::fit_suite_near(others, curve_.pooled->law()).law;
    return law ? std::optional(rate_of(by_law_of(*law, weights), pieces_)) : std::nullopt;
  }

  /// The mean over the records is the observed rate. A range of the tail is shared out by the mean of the shares that a
  /// record has in the probabilities at its two ends.
  [[nodiscard]] double rate_of_record(std::size_t record) const {
    const std::vector<double> own = counted_of_record(record);
    if (!tail_.end()) return rates_.rate(own);
    const std::vector<double> means = observed();
    const auto of_all = rates_.probability(means);
    double rate = rate_of(rates_.probability(own), pieces_within(pieces_, tail_.y().back(), HUGE_VAL));
    for (std::size_t i = 0; i < tail_.size(); ++i) {
      const double low = i == 0 ? -HUGE_VAL : tail_.y()[i];
      const double share = 0.5 * (own[i] / means[i] + own[i + 1] / means[i + 1]);
      rate += share * rate_of(of_all, pieces_within(pieces_, low, tail_.y()[i + 1]));
    }
    return rate;
  }

  void set_records(bool is_by_law, SuiteRate& found) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < suite_.size(); ++r) {
      found.by_record.push_back(
          {.name = curve_.records[r].name, .rate = rate_of_record(r), .without = without(r, is_by_law)});
      sum += found.by_record.back().rate;
    }
    for (RateOfRecord& record : found.by_record) record.share = sum > 0.0 ? record.rate / sum : 0.0;
    set_leave_one_out(found);
  }

  void set_leave_one_out(SuiteRate& found) const {
    std::vector<double> rates;
    for (const RateOfRecord& record : found.by_record) {
      if (record.without) rates.push_back(*record.without);
    }
    if (rates.size() < 2 || rates.size() < found.by_record.size()) return;
    const auto [least, most] = std::ranges::minmax(rates);
    found.leave_one_out = stats::Interval{.low = least, .high = most};
    if (!(least > 0.0) || !(found.chosen.value > 0.0)) return;
    double mean = 0.0, squares = 0.0;
    const auto count = static_cast<double>(rates.size());
    for (const double rate : rates) mean += std::log(rate) / count;
    for (const double rate : rates) squares += (std::log(rate) - mean) * (std::log(rate) - mean);
    const double error = std::sqrt((count - 1.0) / count * squares);
    const double factor = std::exp(stats::two_sided_t_quantile(curve_.subject.confidence, count - 1.0) * error);
    found.jackknife = stats::Interval{.low = found.chosen.value / factor, .high = found.chosen.value * factor};
  }

  void set_undecided(SuiteRate& found) const {
    const std::vector<double> means = observed();
    std::uint64_t trials = 0;
    for (const auto& record : suite_) trials += record.front().happened.trials;
    const std::vector<LevelShare> levels = rates_.levels(means, 0.5 / static_cast<double>(trials));
    const double rate = rates_.rate(means);
    double open = 0.0;
    for (const UndecidedRange& range : undecided_ranges(levels, counted_.hazard, counted_.start)) open += range.rate;
    found.undecided_share = rate > 0.0 ? open / rate : (open > 0.0 ? 1.0 : 0.0);
    const auto between = rates_.probability(means);
    found.add_levels =
        levels_to_add(levels, counted_.hazard, counted_.start, most_undecided_share * rate, [&](double intensity) {
          if (curve_.pooled) {
            return by_law_of(curve_.pooled->law(), equal_weights()).probability(std::log(intensity));
          }
          return intensity > levels.back().intensity ? 0.5 * (1.0 + means.back())
                                                     : between.probability(std::log(intensity));
        });
    if (!found.do_estimates_agree() && found.add_levels.empty())
      found.add_levels.push_back(where_law_differs_most(found));
  }

  /// Inside the range whose rates by the law and by the observed shares differ most.
  [[nodiscard]] double where_law_differs_most(const SuiteRate& found) const {
    const auto of_shares = rates_.probability(observed());
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
  stats::RecordShares shares_;
  SuiteTail tail_;
  CountedHazard counted_;
  std::vector<HazardPiece> pieces_;
  SharesAndHazard rates_;
};

}  // namespace

std::string_view to_string(RateSource source) {
  switch (source) {
    case RateSource::law: return "law";
    case RateSource::levels: return "levels";
    case RateSource::isotonic: return "isotonic";
    case RateSource::observed: return "observed";
    case RateSource::at_least: return "at_least";
    case RateSource::at_most: break;
  }
  return "at_most";
}

RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard) {
  ROCKING_EXPECT(base.records.size() == option.records.size());
  const SuiteRates of_base(base, hazard), of_option(option, hazard);
  RateComparison found{.base = base.subject.others, .option = option.subject.others, .event = option.subject.event};
  const std::vector<double> equal(base.records.size(), 1.0);
  const double before = of_base.rate_by(RateSource::isotonic, equal);
  const double after = of_option.rate_by(RateSource::isotonic, equal);
  found.difference = after - before;
  if (before > 0.0) found.ratio = after / before;
  std::vector<double> differences, ratios;
  for (const std::vector<double>& weights : base.bootstrap.weights) {
    const double first = of_base.rate_by(RateSource::isotonic, weights);
    const double second = of_option.rate_by(RateSource::isotonic, weights);
    differences.push_back(second - first);
    if (first > 0.0) ratios.push_back(second / first);
  }
  found.interval = base.interval_of(std::move(differences));
  if (found.ratio) {
    found.ratio_interval = base.interval_of(std::move(ratios));
  }
  return found;
}

SuiteRate annual_rate(const SuiteCurve& curve, const HazardCurve& hazard) {
  ROCKING_EXPECT(!curve.records.empty() && !curve.levels.empty());
  return SuiteRates(curve, hazard).all();
}

}  // namespace rocking
