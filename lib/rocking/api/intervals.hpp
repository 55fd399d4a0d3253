#pragma once

#include <cstdint>

#include "rocking/api/export.hpp"
#include "rocking/stats/interval.hpp"

/// Two-sided confidence intervals of a probability, as in reports: within [0, 1], and [0, 1] without trials. `confidence`
/// is between 0 and 1. They throw base::InputError for another confidence, or for more successes than trials.
namespace rocking {

/// Exact interval: covers the true value at least as often as promised.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] ROCKING_API stats::Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials,
                                                          double confidence = 0.95);

/// Score interval: narrower, covers the true value as often as promised on average over it.
/// Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209-212.
[[nodiscard]] ROCKING_API stats::Interval wilson(std::uint64_t successes, std::uint64_t trials,
                                                 double confidence = 0.95);

}  // namespace rocking
