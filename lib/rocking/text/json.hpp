#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "rocking/base/error.hpp"

namespace rocking {

/// JSON whose keys keep the order in which they were written, so that equal content gives equal bytes.
using Json = nlohmann::ordered_json;

/// `/a/b` + `c` = `/a/b/c`, with the escapes of RFC 6901.
[[nodiscard]] std::string child_pointer(std::string_view parent, std::string_view key);

/// The last key of a JSON pointer: `/excitation/amplitude` -> `amplitude`.
[[nodiscard]] std::string last_key(std::string_view pointer);

/// A value as one line for a message, cut if it is long.
[[nodiscard]] std::string brief(const Json& value);

/// The kind of a value in words: `a number`, `text`, `a list`, ...
[[nodiscard]] std::string_view kind_name(const Json& value);

/// Reads JSON (RFC 8259) more strictly than the format requires: a repeated key in an object is a problem, and so
/// is nesting deeper than 32 levels. Such problems are appended to `problems`, and the first value of a key is kept.
///
/// Throws InputError with line and column if the text is not JSON, or contains a number outside the range of doubles.
[[nodiscard]] Json parse_json(std::string_view text, std::vector<base::Problem>& problems);

/// The same, but such problems are thrown as InputError.
[[nodiscard]] Json parse_json(std::string_view text);

}  // namespace rocking
