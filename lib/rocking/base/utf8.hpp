#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rocking::base {

/// Length in bytes of the UTF-8 character (RFC 3629) that begins at `start`; 0 if no valid character begins there.
[[nodiscard]] std::size_t utf8_length_at(std::string_view text, std::size_t start);

[[nodiscard]] bool is_utf8(std::string_view text);

/// The escape, such as `\u202e`, of the control of writing direction that begins at `start` of a UTF-8 text; empty if
/// none does. These characters (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069) let text look as another:
/// a file `a<U+202E>2ta.exe` is shown as `aexe.at2`.
[[nodiscard]] std::string direction_control_at(std::string_view text, std::size_t start);

}  // namespace rocking::base
