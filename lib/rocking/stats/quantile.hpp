#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
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
