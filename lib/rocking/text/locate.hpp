#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking {

/// The lines, from 1, of the value at a JSON pointer in a JSON text. A key that occurs more than once has several. If
/// the pointer leads to nothing, the line of the innermost value on its path. Takes time in proportion to the text.
[[nodiscard]] std::vector<std::size_t> lines_of(std::string_view text, std::string_view pointer);

/// The same problems; those of the text itself with file and line.
[[nodiscard]] base::InputError located(const base::InputError& error, std::string_view text, const std::string& file);

}  // namespace rocking
