#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/base/number_text.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking {

using base::significant;

/// `number` with `decimals` digits after the point.
[[nodiscard]] std::string fixed_point(double number, int decimals);

/// A probability in per cent, or a difference of two: `98.5`, `0.016`, `99.984`. At least `least_decimals` digits stand
/// after the point, and as many as leave two significant digits of the probability and of its complement. Only 0 and 1
/// are written as 0.0 and 100.0.
[[nodiscard]] std::string per_cent(double probability, int least_decimals = 1);

/// Likewise both ends, in brackets.
[[nodiscard]] std::string per_cent(const stats::Interval& interval, int least_decimals = 1);

/// Likewise the share of `count` in `all`.
[[nodiscard]] std::string per_cent_of(std::uint64_t count, std::uint64_t all);

/// A rate, or a quotient of two, in two digits also where the second is a zero: `263`, `24`, `1.0`, `0.50`, `5.0e-4`.
[[nodiscard]] std::string rate_text(double rate);

/// ` (48)` where the count cannot be read from `all` and the share in tenths of a per cent; otherwise empty.
[[nodiscard]] std::string count_if_open(std::uint64_t count, std::uint64_t all);

/// What that number is, for the legend of a table whose rows have at most so many realisations: `; (k): k realisations`,
/// or empty.
[[nodiscard]] std::string count_legend(std::uint64_t most);

/// `1 condition`, `2 conditions`.
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun);

/// A level of confidence in per cent, in as many digits as tell it from 0 and from 1: `95`, `99.9`, `99.9999999999`.
[[nodiscard]] std::string level_text(double confidence);

/// `[2.20, 2.43]`; an infinite upper end is `unbounded`.
[[nodiscard]] std::string interval_in_words(const stats::Interval& interval);

/// `820 kB`, `2.4 GB`.
[[nodiscard]] std::string size_in_words(std::uint64_t bytes);

/// `12 s`, `3 min 20 s`, `2 h 05 min`.
[[nodiscard]] std::string duration_in_words(double seconds);

/// 64 bits in decimal, or in hexadecimal after `0x`; absent if the text is neither.
[[nodiscard]] std::optional<std::uint64_t> seed_from_text(std::string_view text);

/// `0x2012`. Seeds are always written as text, because some programs cannot read 64 bits from a JSON number.
[[nodiscard]] std::string seed_text(std::uint64_t seed);

}  // namespace rocking
