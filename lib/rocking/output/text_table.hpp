#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rocking {

/// Number of characters of a text in UTF-8.
[[nodiscard]] std::size_t letters_in(std::string_view text);

using TextRow = std::vector<std::string>;

/// Rows of equal length as lines of columns, each as wide as its widest cell, two blanks apart, flush right.
[[nodiscard]] std::string aligned(const std::vector<TextRow>& rows);

}  // namespace rocking
