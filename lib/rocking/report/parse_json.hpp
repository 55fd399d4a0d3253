#pragma once

#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/report/json.hpp"

namespace rocking::report {

/// Reads JSON (RFC 8259) more strictly than the format demands: a key that stands twice in an object is a problem, and so
/// is nesting deeper than 32 levels. Such problems are appended to `problems`, and the first value of a key is kept.
///
/// Throws InputError, with line and column, where the text is not JSON, or holds a number outside the range of doubles.
[[nodiscard]] Json parse_json(std::string_view text, std::vector<base::Problem>& problems);

}  // namespace rocking::report
