#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/base/number_text.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking {

using base::significant;

/// `number` with `decimals` digits after the point.
[[nodiscard]] std::string fixed_point(double number, int decimals);

/// A probability in per cent, with `decimals` digits after the point.
[[nodiscard]] std::string per_cent(double probability, int decimals = 1);

/// Likewise both ends, in brackets.
[[nodiscard]] std::string per_cent(const stats::Interval& interval, int decimals = 1);

/// The upper bound of the probability of what did not occur, in per cent: `2.8`. Below 0.1 % with two significant
/// digits, since a bound is never 0.
[[nodiscard]] std::string upper_bound_text(double probability);

/// `1 condition`, `2 conditions`.
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun);

/// A level of confidence in per cent, in as many digits as tell it from 0 and from 1: `95`, `99.9`, `99.9999999999`.
[[nodiscard]] std::string level_text(double confidence);

/// `820 kB`, `2.4 GB`.
[[nodiscard]] std::string spoken_size(std::uint64_t bytes);

/// `12 s`, `3 min 20 s`, `2 h 05 min`.
[[nodiscard]] std::string spoken_duration(double seconds);

}  // namespace rocking
