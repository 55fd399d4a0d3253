#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"

/// Two runs, pairwise with common random numbers.
namespace rocking {

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

/// Compares two runs of the same seed, realisation by realisation with common random numbers: the settings that differ
/// and one entry for each condition, with the confidence of the first run's. Realisations that only one run has are
/// left out. Throws base::InputError if the seeds or the numbers of conditions differ.
[[nodiscard]] ROCKING_API Comparison compare(const StoredRun& first, const StoredRun& second);

}  // namespace rocking
