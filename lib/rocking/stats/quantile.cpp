#include "rocking/stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rocking/base/error.hpp"

namespace rocking::stats {

std::optional<double> censored_quantile(const std::map<std::int64_t, std::uint64_t>& tally, std::uint64_t later,
                                        double level) {
  ROCKING_EXPECT(0.0 < level && level <= 1.0);
  std::uint64_t all = later;
  for (const auto& [value, count] : tally) all += count;
  // 0.55 of 100 is the 55th, though 0.55 * 100.0 > 55: level and product are both rounded, with a relative error of at
  // most 2^-53.
  const double rank = std::max(1.0, std::ceil(level * static_cast<double>(all) * (1.0 - 0x1p-51)));
  std::uint64_t passed = 0;
  for (const auto& [value, count] : tally) {
    passed += count;
    if (static_cast<double>(passed) >= rank) return static_cast<double>(value);
  }
  return std::nullopt;
}

std::optional<double> lower_median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace rocking::stats
