#include "rocking/stats/quantile.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/error.hpp"

namespace rocking::stats {

std::optional<double> censored_quantile(std::span<const double> sorted, std::size_t later, double level) {
  ROCKING_EXPECT(0.0 < level && level <= 1.0);
  ROCKING_EXPECT(std::is_sorted(sorted.begin(), sorted.end()));
  const auto n = static_cast<double>(sorted.size() + later);
  // 0.55 of 100 is the 55th, though 0.55 * 100.0 > 55: level and product are rounded, each by 2^-53 of itself at most.
  const double rank = std::max(1.0, std::ceil(level * n * (1.0 - 0x1p-51)));
  const auto place = static_cast<std::size_t>(rank) - 1;
  if (place >= sorted.size()) return std::nullopt;
  return sorted[place];
}

}  // namespace rocking::stats
