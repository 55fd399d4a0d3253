#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rocking {

/// Least number of letters to insert, delete, replace or swap with a neighbour that turns `a` into `b`.
/// Source: Damerau (1964), CACM 7(3) 171-176, in the restricted form (no letter is edited twice).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word that `written` was most likely meant to be: the nearest, if a third of its letters or fewer are off.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view written, std::span<const std::string> words);

}  // namespace rocking
