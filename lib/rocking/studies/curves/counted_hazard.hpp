#pragma once

#include <algorithm>
#include <cmath>

#include "rocking/studies/curves/annual_rate.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"

namespace rocking {

/// What is counted of a hazard curve, and the levels that can lift the block.
struct CountedHazard {
  /// Intensities whose quotient differs from 1 by less are the same: the least uplift is computed from a record's peak.
  static constexpr double rounding = 1e-12;

  const HazardCurve& hazard;
  double first = 0.0;                                 ///< lowest intensity of the hazard curve
  double start = 0.0;                                 ///< the same, or the least intensity that lifts the block
  std::optional<double> least_uplift = std::nullopt;  ///< absent: not known
  std::vector<double> levels = {};                    ///< that can lift the block; rising

  [[nodiscard]] std::vector<HazardPiece> pieces() const { return pieces_between(hazard, start); }
  /// Up to the last point of the hazard curve.
  [[nodiscard]] std::vector<HazardPiece> within() const {
    return pieces_between(hazard, start, hazard.points.back().intensity);
  }
  /// Beyond it, where the curve is continued; empty if the rate is 0 there.
  [[nodiscard]] std::vector<HazardPiece> beyond() const {
    const HazardPoint& last = hazard.points.back();
    if (!(last.rate > 0.0)) return {};
    return pieces_between(hazard, std::max(start, last.intensity));
  }
  /// Where the rate starts, and the levels above it: the ends of the ranges of a disaggregation.
  [[nodiscard]] std::vector<double> ends_of_ranges() const {
    std::vector<double> ends{start};
    for (const double level : levels) {
      if (level > ends.back() * (1.0 + rounding)) ends.push_back(level);
    }
    return ends;
  }
};

template <class Levels>
CountedHazard counted_hazard(const HazardCurve& hazard, const Levels& levels, std::optional<double> least_uplift) {
  const double first = hazard.points.front().intensity;
  CountedHazard found{.hazard = hazard,
                      .first = first,
                      .start = std::max(first, least_uplift.value_or(first)),
                      .least_uplift = least_uplift};
  for (const auto& level : levels) {
    if (level.intensity >= least_uplift.value_or(0.0) * (1.0 - CountedHazard::rounding)) {
      found.levels.push_back(level.intensity);
    }
  }
  return found;
}

/// Value and disaggregation of a rate, of a probability for which there is `rate_of`.
template <class Probability>
AnnualRate disaggregated(const CountedHazard& counted, const Probability& probability) {
  AnnualRate found;
  found.impossible = rate_of(probability, pieces_between(counted.hazard, counted.first, counted.start));
  if (counted.start == counted.first) found.probability_at_first = probability.probability(std::log(counted.first));
  const std::vector<double> ends = counted.ends_of_ranges();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    RateInRange range;
    range.from = ends[i];
    if (i + 1 < ends.size()) range.to = ends[i + 1];
    range.rate = rate_of(probability, pieces_between(counted.hazard, range.from, range.to));
    const bool is_below =
        counted.levels.empty() || range.from < counted.levels.front() * (1.0 - CountedHazard::rounding);
    range.is_tested = !is_below && range.to.has_value();
    found.value += range.rate;
    if (is_below) found.below_levels += range.rate;
    found.by_level.push_back(range);
  }
  const auto& points = counted.hazard.points;
  const auto zero = std::ranges::find(points, 0.0, &HazardPoint::rate);
  if (zero != points.end()) found.hazard_ends = zero->intensity;
  if (points.front().rate > most_frequent_hazard) found.frequent_hazard = points.front().rate;
  if (const double beyond = rate_of(probability, counted.beyond()); beyond > 0.0) {
    found.extrapolated_hazard = std::min(1.0, beyond / found.value);
    found.within_hazard = rate_of(probability, counted.within());
  } else {
    found.within_hazard = found.value;
  }
  for (RateInRange& range : found.by_level) {
    range.share = found.value > 0.0 ? range.rate / found.value : 0.0;
    if (!range.is_tested) found.untested_share += range.share;
  }
  return found;
}

}  // namespace rocking
