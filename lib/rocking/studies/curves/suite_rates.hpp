#pragma once

#include "rocking/stats/record_shares.hpp"
#include "rocking/studies/curves/counted_hazard.hpp"
#include "rocking/studies/curves/rare_tail.hpp"
#include "rocking/studies/curves/shares_and_hazard.hpp"

namespace rocking {

/// A suite, and what counts of a hazard curve. Refers to both.
struct CountedSuite {
  const SuiteCurve& curve;
  SuiteTail tail;
  CountedHazard counted;  ///< the rare estimates take the place of the levels below the end of the tail
  std::vector<HazardPiece> pieces;

  CountedSuite(const SuiteCurve& of, const HazardCurve& hazard);

  [[nodiscard]] std::vector<double> equal_weights() const { return std::vector<double>(curve.records.size(), 1.0); }
};

/// Rates by the law of a suite that has one.
class LawRates {
 public:
  explicit LawRates(const CountedSuite& suite)
      : suite_(suite), probability_(probability_of(suite.curve.pooled->law(), suite.equal_weights())) {}

  [[nodiscard]] const WithTail<LognormalCapacity>& probability() const { return probability_; }
  [[nodiscard]] double rate() const { return rate_of(probability_, suite_.pieces); }
  /// With the interval of the samples.
  [[nodiscard]] RateEstimate estimate() const;
  /// Of the bootstrap samples that have a law, in their order.
  [[nodiscard]] std::vector<double> of_samples() const;

 private:
  /// Of records with these weights, whose law it is.
  [[nodiscard]] WithTail<LognormalCapacity> probability_of(const stats::SuiteLaw& law,
                                                           const std::vector<double>& weights) const;

  const CountedSuite& suite_;
  WithTail<LognormalCapacity> probability_;
};

/// Rates by isotonic shares. `weights`: of the records.
class ShareRates {
 public:
  explicit ShareRates(const CountedSuite& suite);

  /// Of all records, at the points that count.
  [[nodiscard]] std::vector<double> shares() const { return isotonic(least_, suite_.equal_weights()); }
  [[nodiscard]] std::vector<LevelShare> levels() const { return rates_.levels(shares(), half_trial_); }
  [[nodiscard]] WithTail<KnownProbabilities> probability() const { return rates_.probability(shares()); }
  [[nodiscard]] double rate() const { return rate(least_, suite_.equal_weights()); }
  /// How much larger it is if all trials without an answer have the event.
  [[nodiscard]] double rate_without_answer() const { return rate(most_, suite_.equal_weights()) - rate(); }
  /// With the interval of the records and one that the suite does not have.
  [[nodiscard]] RateEstimate estimate() const;

  /// What the levels allow; trials without an answer have the event at most.
  [[nodiscard]] AllowedRate allowed(const std::vector<double>& weights) const;
  /// The largest rate that they allow of a probability that is another one between them, with its rate.
  template <class Probability>
  [[nodiscard]] double most_of(const Probability& probability, double rate) const {
    return rates_.allowed_outside(probability, rate, shares()).high;
  }
  /// Whether bootstrap samples give different rates.
  [[nodiscard]] bool scatters() const;
  /// By the shares of one record. The mean over the records is the rate of their mean shares.
  [[nodiscard]] double of_record(std::size_t record) const;

 private:
  [[nodiscard]] double rate(const stats::RecordShares& of, const std::vector<double>& weights) const {
    return rates_.rate(isotonic(of, weights));
  }
  [[nodiscard]] std::vector<double> isotonic(const stats::RecordShares& of, const std::vector<double>& weights) const;
  [[nodiscard]] std::vector<double> shares_of_record(const stats::RecordShares& of, std::size_t record) const;
  [[nodiscard]] std::optional<stats::Interval> interval_with_unseen(const std::vector<double>& worst) const;
  [[nodiscard]] std::vector<double> shares_of_unseen(const std::vector<double>& weights, double unseen) const;

  const CountedSuite& suite_;
  stats::RecordShares least_;  ///< trials without an answer did not have the event
  stats::RecordShares most_;   ///< they had it
  SharesAndHazard rates_;
  double half_trial_ = 0.0;  ///< half of one trial over all trials of a level
};

/// From the lower end of one to the upper end of the other.
[[nodiscard]] std::optional<stats::Interval> between(const std::optional<stats::Interval>& lows,
                                                     const std::optional<stats::Interval>& highs);

}  // namespace rocking
