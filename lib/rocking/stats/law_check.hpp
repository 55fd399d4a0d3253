#pragma once

#include <functional>
#include <optional>

#include "rocking/stats/normal_check.hpp"

namespace rocking::stats {

/// A law whose numbers are functions of a number from N(0, 1), with the inverse of that function.
struct LawOfScores {
  double mean = 0.0;
  double sigma = 1.0;                  ///< standard deviation
  std::function<double(double z)> at;  ///< rising
  std::function<double(double x)> score;
};

/// The same checks of a sample that should consist of independent draws from such a law.
///
/// Mean, standard deviation, skewness and kurtosis are those of the numbers, compared with the law's; their standard
/// errors are those of large samples, E[I(x)^2]/n with the influence function I of the moment. Everything else, tests of
/// fit, correlations and tails, is that of the scores under N(0, 1). Source of the influence functions: Ruppert (1987),
/// Am. Stat. 41(1) 1-5. Absent if all numbers are equal. Needs at least 20 numbers.
[[nodiscard]] std::optional<NormalCheck> check_law(const NormalSamples& samples, const LawOfScores& law);

}  // namespace rocking::stats
