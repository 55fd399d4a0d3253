#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"
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

/// Realisations whose response modes differ.
struct ChangedModes {
  stats::Proportion counts;
  stats::Interval interval;  ///< Clopper-Pearson
};

/// One condition under two settings, realisation by realisation with common random numbers.
struct ConditionComparison {
  std::vector<Parameter> parameters = {};  ///< swept values of the first run; set by the caller
  double confidence = 0.95;                ///< of the intervals
  std::uint64_t realisations = 0;          ///< that both runs hold
  ChangedModes changed;
  std::map<section::ResponseMode, ModeComparison> modes;  ///< those that occurred in either run
};

/// Two runs, compared realisation by realisation.
struct Comparison {
  std::vector<std::string> settings;  ///< that differ, in words
  std::optional<double> confidence;   ///< of all intervals; absent where it is swept
  std::vector<ConditionComparison> conditions;
};

/// The first condition that has another record of a suite in the second experiment; the two have as many conditions.
[[nodiscard]] std::optional<std::size_t> condition_with_other_record(const Experiment& first, const Experiment& second);

/// Compares realisations of equal key. One entry for each condition; `confidences` has one number for each. The caller
/// makes sure that the two runs have the same seed and records: only then do equal keys mean common random numbers.
[[nodiscard]] std::vector<ConditionComparison> compare(const Store& first, const Store& second,
                                                       std::span<const double> confidences);

/// McNemar tests in a comparison: one for each mode of each condition.
[[nodiscard]] std::size_t number_of_tests(std::span<const ConditionComparison> conditions);

}  // namespace rocking
