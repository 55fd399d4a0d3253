#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace rocking::stats {

/// Numbers, from 1, of the values in ascending order that bound a quantile. Absent: no value bounds it at this
/// confidence, and the interval is open at this end.
struct QuantileRanks {
  std::optional<std::uint64_t> low;
  std::optional<std::uint64_t> high;
};

/// The quantile at `level` of the distribution behind n independent values: the interval from the `low`-th to the
/// `high`-th value covers it with probability at least `confidence`, whatever the distribution is.
///
/// With K binomial (n, level), `low` is the largest l with P(K <= l - 1) <= (1 - confidence)/2 and `high` the smallest
/// u with P(K >= u) <= (1 - confidence)/2. Each end is missed with at most that probability. For a distribution with
/// ties the coverage is larger. `level` and `confidence` in (0, 1). Source: David & Nagaraja (2003), Order Statistics,
/// 3rd ed., section 7.1.
[[nodiscard]] QuantileRanks quantile_ranks(std::uint64_t n, double level, double confidence);

/// A quantile with its interval. `value` is absent if it is one of the values beyond, or if there are no values; an end
/// is absent if the interval is open there.
struct QuantileEstimate {
  double level = 0.0;
  std::optional<double> value;
  std::optional<double> low;
  std::optional<double> high;
};

/// The quantile at `level` of the values in `ascending` and of `beyond` further values that are only known to be larger
/// than all of these (censored). The estimate is the nearest rank, as in censored_quantile.
[[nodiscard]] QuantileEstimate quantile_estimate(std::span<const double> ascending, std::uint64_t beyond, double level,
                                                 double confidence);

}  // namespace rocking::stats
