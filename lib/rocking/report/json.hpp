#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace rocking::report {

/// JSON whose keys keep the order in which they were written, so that equal content gives equal bytes.
using Json = nlohmann::ordered_json;

/// `/a/b` + `c` = `/a/b/c`, with the escapes of RFC 6901.
[[nodiscard]] std::string child_pointer(std::string_view parent, std::string_view key);

/// A value as one line for a message, cut where it would run on.
[[nodiscard]] std::string brief(const Json& value);

/// `a number`, `text`, `a list`, ... : what a user calls the value.
[[nodiscard]] std::string_view kind_name(const Json& value);

}  // namespace rocking::report
