#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "rocking/studies/fragility_curve.hpp"
#include "rocking/studies/hazard_integral.hpp"
#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {

/// With fewer events the share of a level says little about its probability.
inline constexpr std::uint64_t least_events_of_level = 10;

[[nodiscard]] inline std::uint64_t events_at(const FragilityLevel& level) { return level.overturned.successes; }
[[nodiscard]] inline std::uint64_t events_at(const SuiteLevel& level) { return level.happened.successes; }

/// The intensity of the lowest level with `least_events_of_level`; absent: none.
template <class Levels>
[[nodiscard]] std::optional<double> lowest_sure_level(const Levels& levels) {
  const auto found =
      std::ranges::find_if(levels, [](const auto& level) { return events_at(level) >= least_events_of_level; });
  return found == levels.end() ? std::nullopt : std::optional(found->intensity);
}

/// The rare estimates of a curve, of one motion or of a suite, below its lowest level with `least_events_of_level`.
template <class Curve>
[[nodiscard]] std::vector<RareLevel> rare_below_levels(const Curve& curve) {
  std::vector<RareLevel> used;
  for (const RareLevel& level : curve.rare) {
    if (level.intensity < lowest_sure_level(curve.levels).value_or(0.0)) used.push_back(level);
  }
  return used;
}

/// A piece of a lower tail.
using TailPiece = std::variant<LognormalCapacity, KnownProbabilities>;

/// Through two probabilities: linear on the probit scale in ln x, as a lognormal law; where they do not rise, linear.
[[nodiscard]] TailPiece tail_piece(double y_low, double p_low, double y_high, double p_high);

/// A probability that passes through rare estimates at low intensities, and from the highest node on is `upper`. Below
/// the first node the first piece goes on. Without nodes it is `upper`.
template <class Upper>
class WithTail {
 public:
  /// `y`: ln x of the nodes, rising; the last one belongs to `upper`. `probabilities`: of the nodes but the last.
  WithTail(const std::vector<double>& y, std::vector<double> probabilities, Upper upper)
      : y_(y), upper_(std::move(upper)) {
    if (y_.empty()) return;
    probabilities.push_back(upper_.probability(y_.back()));
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

}  // namespace rocking
