#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace rocking {

/// Where a word stands in a line of a header, in letters of any case and between characters that are not letters or
/// digits. `word`: in lower case.
[[nodiscard]] std::optional<std::size_t> word_place(std::string_view line, std::string_view word);

/// Whether a line begins with a word, in letters of any case.
[[nodiscard]] bool begins_with_word(std::string_view line, std::string_view word);

/// The number that a header gives to a word: `NPTS=  4000`, `dt = .005`, `DT: .005`; absent if none follows.
[[nodiscard]] std::optional<std::string_view> number_after(std::string_view line, std::string_view word);

}  // namespace rocking
