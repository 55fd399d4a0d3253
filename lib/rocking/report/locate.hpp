#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::report {

/// The lines, from 1, on which the value at a JSON pointer stands in a JSON text. A key that stands more than once has several.
/// Where the pointer leads to nothing: the line of the innermost value on the way. Takes time in proportion to the text.
[[nodiscard]] std::vector<std::size_t> lines_of(std::string_view text, std::string_view pointer);

/// The same problems, of which those about the text itself tell the file and the line.
[[nodiscard]] base::InputError located(const base::InputError& error, std::string_view text, const std::string& file);

}  // namespace rocking::report
