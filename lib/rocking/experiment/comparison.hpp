#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "rocking/experiment/store.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"

namespace rocking::experiment {

/// One condition under two settings, realisation by realisation with common draws.
struct ConditionComparison {
  std::uint64_t realisations = 0;                              ///< that both runs hold
  stats::Proportion changed;                                   ///< of them, those with another response mode
  std::map<section::ResponseMode, stats::PairedCounts> modes;  ///< those that occurred in either
};

/// Compares realisations of equal key. One entry for each of the first `conditions` conditions. The two stores have their
/// seed in common, which the caller sees to: only then do equal keys mean equal draws.
[[nodiscard]] std::vector<ConditionComparison> compare(const Store& first, const Store& second, std::size_t conditions);

}  // namespace rocking::experiment
