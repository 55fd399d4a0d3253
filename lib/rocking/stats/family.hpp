#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rocking::stats {

/// With what probability a value p of one category's probability may be rejected though it is the true one:
/// fixed + proportional p.
struct Doubt {
  double fixed = 0.0;
  double proportional = 0.0;

  [[nodiscard]] constexpr double at(double p) const { return fixed + proportional * p; }
};

/// Categories, one of which each trial falls into: so many `foreseen` ones, settled before there were data, and any
/// number of others, of which nothing is known until they occur.
///
/// Statements about all of them hold at once with probability `confidence`, if each is made with its doubt: a foreseen
/// category takes the share 1/(foreseen + 1) of 1 - confidence; all the others have one such share in common, divided
/// in proportion to their probabilities, which add up to 1 at most, however many they are (Bonferroni's inequality with
/// weights that depend on what is tested). confidence in (0, 1).
struct Family {
  std::size_t foreseen = 0;
  double confidence = 0.95;

  [[nodiscard]] constexpr double share() const { return (1.0 - confidence) / static_cast<double>(foreseen + 1); }
  [[nodiscard]] constexpr Doubt of_foreseen() const { return {.fixed = share(), .proportional = 0.0}; }
  [[nodiscard]] constexpr Doubt of_unforeseen() const { return {.fixed = 0.0, .proportional = share()}; }
};

/// How often each category of a family occurred in so many trials.
struct CategoryCounts {
  std::uint64_t trials = 0;
  std::vector<std::uint64_t> foreseen;    ///< as many as the family foresees, also those that never occurred
  std::vector<std::uint64_t> unforeseen;  ///< those that occurred
};

}  // namespace rocking::stats
