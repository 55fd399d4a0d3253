#pragma once

#include <functional>

#include "rocking/studies/curves/counted_hazard.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/curves/rare_tail.hpp"

namespace rocking {

/// The mean share of a suite at a level.
struct LevelShare {
  double intensity = 0.0;
  double share = 0.0;
  double half_trial = 0.0;  ///< half of one trial over all trials: a share nearer to 0 or 1 is not told from them
};

/// A range of intensity, and the part of a rate that its ends leave open.
struct UndecidedRange {
  double from = 0.0;
  std::optional<double> to;  ///< absent: no end
  double rate = 0.0;         ///< [1/year]
};

/// What the levels leave open of the rate from `start` on, by ranges: below the first level and above the last one the
/// difference between the least and the largest possible rate of a probability that does not decrease; between two levels
/// the difference between two curves through their shares, linear in ln x and lognormal (linear in the probit). Levels by
/// growing intensity, at least one, none below `start`.
[[nodiscard]] std::vector<UndecidedRange> undecided_ranges(const std::vector<LevelShare>& levels,
                                                           const HazardCurve& hazard, double start);

/// Intensities to add until, with the shares there that `expected` gives, at most `goal` [1/year] would stay open; at most
/// eight, with two or three digits, by growing intensity.
[[nodiscard]] std::vector<double> levels_to_add(std::vector<LevelShare> levels, const HazardCurve& hazard, double start,
                                                double goal, const std::function<double(double)>& expected);

/// An intensity inside a range, with as few digits as possible: its middle in ln x, or beyond a range without an end.
[[nodiscard]] double inside(double from, std::optional<double> to);

/// The smallest and the largest rate that levels allow, by the curve between them.
struct AllowedRate {
  stats::Interval linear, lognormal;

  [[nodiscard]] double low() const { return std::min(linear.low, lognormal.low); }
  [[nodiscard]] double high() const { return std::max(linear.high, lognormal.high); }
};

/// Rare estimates, and shares at the levels that can lift the block, as probabilities that are integrated over the
/// hazard.
class SharesAndHazard {
 public:
  /// `levels`: of the suite, also those that cannot lift the block. Keeps references.
  SharesAndHazard(const CountedHazard& counted, std::size_t levels, const SuiteTail& tail);

  /// The probabilities of the tail, and the shares without those of the levels below it or below the least uplift.
  [[nodiscard]] std::vector<double> counted_of(std::vector<double> shares, const std::vector<double>& tail) const;
  [[nodiscard]] WithTail<KnownProbabilities> probability(const std::vector<double>& counted) const;
  /// The rate of these probabilities; without a tail it is linear in them.
  [[nodiscard]] double rate(const std::vector<double>& shares) const;
  /// The least and the largest rate of a probability that does not decrease and has these shares at the levels; between
  /// rare estimates that of the lines.
  [[nodiscard]] double least_allowed(const std::vector<double>& shares) const;
  [[nodiscard]] double most_allowed(const std::vector<double>& shares) const;
  /// Of a record that is not in the suite, at worst: the largest probability of any record at up to twice the intensity,
  /// or at the next level; 1 where that lies above the levels.
  [[nodiscard]] std::vector<double> worst_unseen(const std::vector<std::vector<double>>& counted_of_records) const;
  /// The smallest and the largest rate of a probability with these shares at the levels, if it does not decrease: from 0
  /// to the first share below the levels, from the last one to 1 above them.
  template <class Probability>
  [[nodiscard]] stats::Interval allowed_outside(const Probability& probability, double rate,
                                                const std::vector<double>& shares) const {
    const double below = rate_of(probability, pieces_below_), above = rate_of(probability, pieces_above_);
    const double least_above = shares.back() * ranges_.back();
    return {
        .low = std::max(0.0, rate - below - std::max(0.0, above - least_above)),
        .high = rate + std::max(0.0, shares.front() * ranges_.front() - below) + std::max(0.0, ranges_.back() - above)};
  }
  /// Of these shares, linear and lognormal between two levels.
  [[nodiscard]] AllowedRate allowed(const std::vector<double>& shares, double half_trial) const;
  [[nodiscard]] std::vector<LevelShare> levels(const std::vector<double>& shares, double half_trial) const;

 private:
  /// The first range between levels that is not one of the tail.
  [[nodiscard]] std::size_t first_of_levels() const { return std::max<std::size_t>(1, tail_.y.size()); }
  [[nodiscard]] double in_tail(const std::vector<double>& shares) const;
  /// Linear in ln x; 0 at the least uplift where that is known, wherever the hazard begins, and beyond the levels as at
  /// the last one.
  [[nodiscard]] KnownProbabilities known(const std::vector<double>& shares) const;
  [[nodiscard]] double hazard_between(double from, std::optional<double> to) const;

  const HazardCurve& hazard_;
  const SuiteTail& tail_;
  double start_;
  std::optional<double> least_uplift_;  ///< also where the hazard begins above it: less hazard is no higher rate
  std::vector<HazardPiece> pieces_;
  std::vector<HazardPiece> pieces_below_, pieces_above_;  ///< outside the levels
  bool is_below_uplift_ = false;
  std::size_t skipped_ = 0;
  std::vector<double> intensities_;
  std::vector<double> weights_;  ///< derivatives of the rate by the shares
  std::vector<double> ranges_;   ///< hazard from the start to the first level, between levels, and beyond the last
};

}  // namespace rocking
