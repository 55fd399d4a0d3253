#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Counts of a sample in equal bins, with the counts expected under a normal law. Numbers outside the bins are counted
/// in `below` and `above`. Bin k is [edges[k], edges[k + 1]).
struct Histogram {
  std::vector<double> edges;  ///< bins + 1 of them, ascending
  std::vector<std::uint64_t> counts;
  std::vector<double> expected;  ///< n (F(upper edge) - F(lower edge))
  std::uint64_t below = 0;
  std::uint64_t above = 0;  ///< numbers >= the last edge
  double expected_below = 0.0;
  double expected_above = 0.0;
};

/// `bins` >= 1 equal bins from mean - reach sigma to mean + reach sigma; reach > 0.
[[nodiscard]] Histogram normal_histogram(std::span<const double> sample, const NormalLaw& law, std::size_t bins,
                                         double reach);

}  // namespace rocking::stats
