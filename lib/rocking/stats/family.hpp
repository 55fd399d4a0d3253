#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rocking::stats {

/// Significance level of the test of a value p of a category's probability: the probability of rejecting p if it is the
/// true value, fixed + proportional p.
struct Significance {
  double fixed = 0.0;
  double proportional = 0.0;

  [[nodiscard]] constexpr double at(double p) const { return fixed + proportional * p; }
};

/// A family of categories; each trial falls into exactly one of them. Some categories are prespecified, that is, fixed
/// before there were data. There may be any number of others, which are unknown until they occur.
///
/// Statements about all categories hold at once with probability `confidence`, in (0, 1), if each uses its significance
/// level. A prespecified category receives the share 1/(prespecified + 1) of 1 - confidence. All others together
/// receive one such share, divided in proportion to their probabilities. These add up to 1 at most, however many
/// categories there are (Bonferroni's inequality with weights that depend on the tested value).
struct Family {
  std::size_t prespecified = 0;
  double confidence = 0.95;

  [[nodiscard]] constexpr double share() const { return (1.0 - confidence) / static_cast<double>(prespecified + 1); }
  [[nodiscard]] constexpr Significance of_prespecified() const { return {.fixed = share(), .proportional = 0.0}; }
  [[nodiscard]] constexpr Significance of_others() const { return {.fixed = 0.0, .proportional = share()}; }
};

/// How often each category of a family occurred in a number of trials.
struct CategoryCounts {
  std::uint64_t trials = 0;
  std::vector<std::uint64_t> prespecified;  ///< one count for each prespecified category, also if it is 0
  std::vector<std::uint64_t> others;        ///< counts of the others that occurred
};

}  // namespace rocking::stats
