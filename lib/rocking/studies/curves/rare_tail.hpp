#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "rocking/studies/curves/fragility_curve.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"

namespace rocking {

/// With fewer events the share of a level says little about its probability.
inline constexpr std::uint64_t least_events_of_level = 10;

/// The intensity of the lowest level with `least_events_of_level`; absent: none.
template <class Levels>
[[nodiscard]] std::optional<double> lowest_sure_level(const Levels& levels) {
  const auto found = std::ranges::find_if(
      levels, [](const auto& level) { return level.overturned.successes >= least_events_of_level; });
  return found == levels.end() ? std::nullopt : std::optional(found->intensity);
}

/// The rare estimates that give the lower tail of a curve, of one motion or of a suite.
struct UsedRare {
  std::vector<RareLevel> estimates;  ///< by growing intensity; empty: none is used
  std::optional<double> end;         ///< the level from which on the levels count; absent: the highest estimate ends it
  std::optional<RareUse> use;        ///< absent: the curve has no estimates
  std::vector<double> y = {};        ///< ln x of the nodes, the estimates and the end; empty without a tail

  /// Up to this intensity the estimates give the probabilities.
  [[nodiscard]] std::optional<double> reach() const {
    return end || estimates.empty() ? end : std::optional(estimates.back().intensity);
  }
};

/// Those below the lowest level with `least_events_of_level`; all, where no level has so many. These end at the level
/// above them that has the most events, or, where none has any, at the highest of at least two.
template <class Curve>
[[nodiscard]] UsedRare used_rare(const Curve& curve) {
  if (curve.rare.empty()) return {};
  UsedRare used{.estimates = curve.rare, .end = lowest_sure_level(curve.levels), .use = RareUse::below_sure_level};
  if (used.end) {
    std::erase_if(used.estimates, [&](const RareLevel& level) { return level.intensity >= *used.end; });
  } else {
    std::uint64_t most = 0;
    for (const auto& level : curve.levels) {
      if (level.intensity <= curve.rare.back().intensity || level.overturned.successes <= most) continue;
      most = level.overturned.successes;
      used.end = level.intensity;
    }
    used.use = used.end ? RareUse::below_best_level : RareUse::up_to_highest;
    if (!used.end && used.estimates.size() < 2) used.estimates.clear();
  }
  if (used.estimates.empty()) return {.estimates = {}, .end = std::nullopt, .use = RareUse::not_used};
  for (const RareLevel& level : used.estimates) used.y.push_back(std::log(level.intensity));
  if (used.end) used.y.push_back(std::log(*used.end));
  return used;
}

/// A piece of a lower tail.
using TailPiece = std::variant<LognormalCapacity, KnownProbabilities>;

/// Through two probabilities: linear on the probit scale in ln x, as a lognormal law; where they do not rise, linear.
[[nodiscard]] TailPiece tail_piece(double y_low, double p_low, double y_high, double p_high);

/// A probability that passes through rare estimates at low intensities, and from the highest node on is `upper`. Below
/// the first node the first piece goes on. Without nodes it is `upper`; else there are at least two.
template <class Upper>
class WithTail {
 public:
  /// `y`: ln x of the nodes, rising. `probabilities`: of the nodes; without that of the last one it belongs to `upper`.
  WithTail(const std::vector<double>& y, std::vector<double> probabilities, Upper upper)
      : y_(y), upper_(std::move(upper)) {
    if (y_.empty()) return;
    if (probabilities.size() < y_.size()) probabilities.push_back(upper_.probability(y_.back()));
    for (std::size_t i = 0; i + 1 < y_.size(); ++i) {
      pieces_.push_back(tail_piece(y_[i], probabilities[i], y_[i + 1], probabilities[i + 1]));
    }
  }

  [[nodiscard]] double probability(double y) const {
    if (y_.empty() || y >= y_.back()) return upper_.probability(y);
    const auto next = static_cast<std::size_t>(std::upper_bound(y_.begin(), y_.end(), y) - y_.begin());
    return std::visit([y](const auto& piece) { return piece.probability(y); }, pieces_[next < 1 ? 0 : next - 1]);
  }

  friend double rate_of(const WithTail& tail, const std::vector<HazardPiece>& hazard) {
    if (tail.y_.empty()) return rate_of(tail.upper_, hazard);
    double rate = rate_of(tail.upper_, pieces_within(hazard, tail.y_.back(), HUGE_VAL));
    for (std::size_t i = 0; i + 1 < tail.y_.size(); ++i) {
      const auto part = pieces_within(hazard, i == 0 ? -HUGE_VAL : tail.y_[i], tail.y_[i + 1]);
      rate += std::visit([&part](const auto& piece) { return rate_of(piece, part); }, tail.pieces_[i]);
    }
    return rate;
  }

 private:
  std::vector<double> y_;
  Upper upper_;
  std::vector<TailPiece> pieces_;
};

/// The rare estimates that give the lower tail of a suite (used_rare), record by record: sampling that is stratified by
/// records, each with its weight.
struct SuiteTail : UsedRare {
  explicit SuiteTail(const SuiteCurve& curve);

  /// Means over the records with these weights, >= 0, not all 0.
  [[nodiscard]] std::vector<double> means(const std::vector<double>& weights) const;

  std::vector<std::vector<double>> of_records;  ///< by record and estimate; 0 where it has none
};

}  // namespace rocking
