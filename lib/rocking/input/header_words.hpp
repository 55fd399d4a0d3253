#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/input/record_unit.hpp"

namespace rocking {

/// Where a word stands in a line of a header, in letters of any case and between characters that are not letters or
/// digits. `word`: in lower case.
[[nodiscard]] std::optional<std::size_t> word_place(std::string_view line, std::string_view word);

/// Whether a line begins with a word, in letters of any case.
[[nodiscard]] bool begins_with_word(std::string_view line, std::string_view word);

/// The number that a header gives to a word: `NPTS=  4000`, `dt = .005`, `DT: .005`; absent if none follows.
[[nodiscard]] std::optional<std::string_view> number_after(std::string_view line, std::string_view word);

/// A unit that a line of a header states.
struct StatedUnit {
  std::string_view text;
  WrittenUnit unit;
};

/// What stands after each word `units` or `unit` of a line: `IN UNITS OF CM/SEC/SEC`, `The units are (g)`, `UNITS: %G`.
/// Of unknown kind where it is no unit, or goes on as a formula does (`G X 100`).
[[nodiscard]] std::vector<StatedUnit> units_stated(std::string_view line);

/// The units of acceleration and velocity among the words of a line and between its brackets: `ACCELERATION (CM/S/S)`,
/// `a [10^-2 m/s2]`, `g*1000`. A word behind a number is the unit of that number and is left out. Units of length are left
/// out too: `IN` is also a word.
[[nodiscard]] std::vector<StatedUnit> units_among_words(std::string_view line);

/// What stands between the brackets of a line: `a [g] (filtered)` has two.
[[nodiscard]] std::vector<std::string_view> in_brackets(std::string_view line);

}  // namespace rocking
