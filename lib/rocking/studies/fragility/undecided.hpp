#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rocking/studies/fragility/hazard_integral.hpp"

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

/// The rate between two levels of the lognormal curve through their shares, less that of the curve linear in ln x; 0 where
/// the shares do not rise.
[[nodiscard]] double lognormal_less_linear(const LevelShare& low, const LevelShare& high, const HazardCurve& hazard);

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

}  // namespace rocking
