#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "rocking/scene/hazard.hpp"

namespace rocking {

/// Most points of a hazard curve, and most bytes of its file.
inline constexpr std::size_t most_hazard_points = 10'000;
inline constexpr std::size_t most_hazard_bytes = 10'000'000;

/// Reads a hazard curve: a line `intensity, annual rate of exceedance` for each point, between commas, semicolons or
/// blanks; `#` begins a comment. The first line may name the columns (lib/docs/formats.md). `name`: of the file, for
/// messages.
///
/// Throws base::InputError with line, value and remedy of every fault: a line without two numbers, an intensity that is
/// not positive or does not rise, a rate that is not positive or does not fall, fewer than two points or more than
/// `most_hazard_points`, a text of more than `most_hazard_bytes`.
[[nodiscard]] HazardCurve read_hazard(std::string_view text, const std::string& name);

}  // namespace rocking
