#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rocking::report {

/// What a terminal can show.
enum class Letters : std::uint8_t { ascii, unicode };

/// How many parts of a bar have a mark of their own.
inline constexpr std::size_t most_marks = 6;

/// The mark of the part of a bar at `place`, from 0 to most_marks - 1; the last one is the palest.
[[nodiscard]] std::string mark_of(std::size_t place, Letters letters);

struct BarLook {
  std::size_t length = 12;  ///< in letters
  Letters letters = Letters::ascii;
};

/// `counts` as a bar, each part as long as its share and drawn in its mark. A part that is there at all
/// has a letter at least: what is rare shows. There are most_marks counts at most, not all 0, and no fewer
/// letters.
[[nodiscard]] std::string share_bar(const std::vector<std::uint64_t>& counts, const BarLook& look);

}  // namespace rocking::report
