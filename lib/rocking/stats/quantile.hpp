#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace rocking::stats {

/// The quantile at `level` in (0, 1] of values that `tally` counts, and of `later` more that are only known to be larger
/// than any of them.
///
/// Nearest rank: the smallest value that at least a fraction `level` of all do not exceed, hence always one that
/// occurred. Absent where it falls among the later ones, and of nothing. (Hyndman & Fan 1996, definition 1.)
[[nodiscard]] std::optional<double> censored_quantile(const std::map<std::int64_t, std::uint64_t>& tally,
                                                      std::uint64_t later, double level);

}  // namespace rocking::stats
