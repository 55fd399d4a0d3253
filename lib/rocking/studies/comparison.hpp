#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"

namespace rocking {

class Store;

/// A response mode under two settings.
struct ModeComparison {
  stats::PairedCounts counts;
  double in_first = 0.0;                     ///< share of the realisations of the first run that have the mode
  double in_second = 0.0;                    ///< the same of the second run
  double difference = 0.0;                   ///< in_first - in_second
  stats::Interval score;                     ///< of the difference: Tango's
  stats::Interval exact;                     ///< of the difference: see stats::paired_difference_exact
  stats::McNemar test;                       ///< of whether the difference is 0
  std::optional<double> variance_reduction;  ///< by common random numbers; absent where no two realisations differ
};

/// One condition under two settings, realisation by realisation with common random numbers.
struct ConditionComparison {
  double confidence = 0.95;                               ///< of the intervals
  std::uint64_t realisations = 0;                         ///< that both runs hold
  stats::Proportion changed;                              ///< those of them whose response modes differ
  stats::Interval changed_interval;                       ///< Clopper-Pearson
  std::map<section::ResponseMode, ModeComparison> modes;  ///< those that occurred in either run
};

/// Compares realisations of equal key. One entry for each condition; `confidences` has one number for each. The caller
/// makes sure that the two runs have the same seed: only then do equal keys mean common random numbers.
[[nodiscard]] std::vector<ConditionComparison> compare(const Store& first, const Store& second,
                                                       std::span<const double> confidences);

/// McNemar tests in a comparison: one for each mode of each condition.
[[nodiscard]] std::size_t number_of_tests(std::span<const ConditionComparison> conditions);

}  // namespace rocking
