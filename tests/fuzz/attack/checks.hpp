#pragma once

#include <string>
#include <string_view>

namespace rocking::fuzz {

/// The first control character of `text` other than a line feed or tabulator, with its place; empty where there is none.
[[nodiscard]] std::string control_character_in(std::string_view text);

/// Whether `text` is UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

/// What is wrong with the nesting of a page's elements or with its signs `<` and `&`; empty where nothing is.
[[nodiscard]] std::string damage_of_page(std::string_view page);

}  // namespace rocking::fuzz
