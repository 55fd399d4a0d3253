#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rocking {

/// Number of characters of a text in UTF-8.
[[nodiscard]] std::size_t letters_in(std::string_view text);

/// The text with lines of at most `width` letters, broken between words; the lines that follow keep the indentation. Lines of
/// a table, which have two blanks between words, stay as they are.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);

/// How much of a result is printed: what fits one screen, or all.
enum class Extent : std::uint8_t { one_screen, all };

/// Most rows of a table on one screen.
inline constexpr std::size_t most_screen_rows = 40;

/// Whether a result of these lines is printed as it is, and not summarised: all is wanted, or it has at most 55 lines.
[[nodiscard]] bool is_printed_whole(std::string_view text, Extent extent);

/// Characters that a terminal can show.
enum class Letters : std::uint8_t { ascii, unicode };

/// Largest number of parts of a bar; each has a different mark.
inline constexpr std::size_t most_marks = 6;

/// The mark of the part of a bar at `place`, from 0 to most_marks - 1; the last one is the lightest.
[[nodiscard]] std::string mark_of(std::size_t place, Letters letters);

struct BarLook {
  std::size_t length = 12;  ///< in letters
  Letters letters = Letters::ascii;
};

/// `counts` as a bar. The length of each part is its share, but at least one letter if its count is not 0, so that
/// rare parts are visible. There are most_marks counts at most, not all 0, and the bar has at least as many
/// letters.
[[nodiscard]] std::string share_bar(const std::vector<std::uint64_t>& counts, const BarLook& look);

}  // namespace rocking
