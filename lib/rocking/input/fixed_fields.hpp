#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"

/// Files whose numbers stand in fields of a fixed width, which may touch.
namespace rocking {

/// What a Fortran format says of a line: `(8F10.5)`.
struct FieldFormat {
  std::size_t count = 0;  ///< of fields in a line
  std::size_t width = 0;  ///< of each, in characters
};

/// The format that stands in brackets in a line, `Format=(8F10.5)`, `(8f9.6)`, `(1E15.6)`; absent if there is none.
[[nodiscard]] std::optional<FieldFormat> field_format_in(std::string_view line);

/// A text with a blank between fields that touch: a line in which something longer than `width` stands is cut into
/// fields of that width.
[[nodiscard]] std::string parted_fields(std::string_view text, std::size_t width);

/// Takes `lines` lines off the front of `text`, and returns their fields, also those that are blank.
[[nodiscard]] std::vector<std::string_view> take_fields(std::string_view& text, std::size_t lines, FieldFormat format,
                                                        LineProblems& problems);

/// Whether a line has numbers, which may touch, and nothing else.
[[nodiscard]] bool is_line_of_numbers(std::string_view line);

/// Takes `lines` lines off the front of `text` as they stand.
[[nodiscard]] std::string_view take_lines(std::string_view& text, std::size_t lines, LineProblems& problems);

/// Lines of so many numbers.
[[nodiscard]] constexpr std::size_t lines_of(std::size_t numbers, std::size_t per_line) {
  return (numbers + per_line - 1) / per_line;
}

}  // namespace rocking
