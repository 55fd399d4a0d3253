#pragma once

#include <string_view>

namespace rocking {

/// What a base does under a kind of excitation, after "a base that"; empty for a name of no kind.
[[nodiscard]] std::string_view excitation_in_words(std::string_view kind);

}  // namespace rocking
