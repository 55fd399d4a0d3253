#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

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

}  // namespace rocking
