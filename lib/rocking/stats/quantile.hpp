#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rocking::stats {

/// Quantile at `level` in (0, 1] of the values counted in `tally` and of `later` further values that are only known to
/// be larger than all of these (censored).
///
/// Nearest rank: the smallest value that is not exceeded by at least a fraction `level` of all values; it is always a
/// value that occurred. Absent if it is one of the censored values, or if there are no values. Source: Hyndman & Fan
/// (1996), Am. Stat. 50, 361-365, definition 1.
[[nodiscard]] std::optional<double> censored_quantile(const std::map<std::int64_t, std::uint64_t>& tally,
                                                      std::uint64_t later, double level);

/// The median of some values; of two middle values the lower one, so that it is always a value that occurred. Absent
/// without values. Source: Hyndman & Fan (1996), definition 1, at level 1/2.
[[nodiscard]] std::optional<double> lower_median(std::vector<double> values);

}  // namespace rocking::stats
