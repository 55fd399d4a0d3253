#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace rocking::stats {

/// The quantile at `level` in (0, 1] of `sorted` values and `later` more that are only known to be larger than any.
///
/// Nearest rank: the smallest value that at least a fraction `level` of all do not exceed, hence always one that
/// occurred. Absent where it falls among the later ones, and of nothing. (Hyndman & Fan 1996, definition 1.)
[[nodiscard]] std::optional<double> censored_quantile(std::span<const double> sorted, std::size_t later, double level);

}  // namespace rocking::stats
