#pragma once

#include <string>
#include <string_view>

namespace rocking::fuzz {

/// The first control character of `text` except line feed and tabulator, with its place; empty if there is none.
[[nodiscard]] std::string control_character_in(std::string_view text);

/// Whether `text` is UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

/// The first fault in the nesting of the elements of a page or in its characters `<` and `&`; empty if there is none.
[[nodiscard]] std::string damage_of_page(std::string_view page);

}  // namespace rocking::fuzz
