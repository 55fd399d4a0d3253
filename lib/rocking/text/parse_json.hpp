#pragma once

#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Reads JSON (RFC 8259) more strictly than the format requires: a repeated key in an object is a problem, and so
/// is nesting deeper than 32 levels. Such problems are appended to `problems`, and the first value of a key is kept.
///
/// Throws InputError with line and column if the text is not JSON, or contains a number outside the range of doubles.
[[nodiscard]] Json parse_json(std::string_view text, std::vector<base::Problem>& problems);

/// The same, but such problems are thrown as InputError.
[[nodiscard]] Json parse_json(std::string_view text);

}  // namespace rocking
