#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/stats/interval.hpp"

namespace rocking::report {

/// `number` in `digits` significant digits, in the shorter of the two notations.
[[nodiscard]] std::string significant(double number, int digits);

/// `number` with `decimals` digits after the point.
[[nodiscard]] std::string fixed_point(double number, int decimals);

/// A probability in per cent, with `decimals` digits after the point.
[[nodiscard]] std::string per_cent(double probability, int decimals = 1);

/// Likewise both ends, in brackets.
[[nodiscard]] std::string per_cent(const stats::Interval& interval, int decimals = 1);

/// A level of confidence in per cent, in as many digits as tell it from 0 and from 1: `95`, `99.9`, `99.9999999999`.
[[nodiscard]] std::string level_text(double confidence);

/// How many letters a text in UTF-8 has.
[[nodiscard]] std::size_t letters_in(std::string_view text);

using TextRow = std::vector<std::string>;

/// Rows of equal length as lines of columns, each as wide as its widest cell, two blanks apart, flush right.
[[nodiscard]] std::string aligned(const std::vector<TextRow>& rows);

}  // namespace rocking::report
