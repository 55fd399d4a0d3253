#pragma once

#include <string_view>
#include <vector>

#include "rocking/input/record_unit.hpp"

namespace rocking {

/// A unit that a line of a header states.
struct StatedUnit {
  std::string_view text;
  WrittenUnit unit;
};

/// What stands after each word `units` or `unit` of a line: `IN UNITS OF CM/SEC/SEC`, `The units are (g)`, `UNITS: %G`.
/// Of unknown kind where it is no unit, or goes on as a formula does (`G X 100`).
[[nodiscard]] std::vector<StatedUnit> units_stated(std::string_view line);

/// The units of acceleration and velocity among the words of a line: `ACCELERATION (CM/S/S)`. A word behind a number is
/// the unit of that number and is left out. Units of length are left out too: `IN` is also a word.
[[nodiscard]] std::vector<StatedUnit> units_among_words(std::string_view line);

}  // namespace rocking
