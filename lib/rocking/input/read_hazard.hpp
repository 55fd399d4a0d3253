#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "rocking/scene/hazard.hpp"

namespace rocking {

/// Most points of a hazard curve, and most bytes of its file.
inline constexpr std::size_t most_hazard_points = 10'000;
inline constexpr std::size_t most_hazard_bytes = 10'000'000;

/// Reads a hazard curve: a line `intensity, annual rate of exceedance`, or `intensity, probability of exceedance`, for
/// each point, between commas, semicolons or blanks; `#` begins a comment. The first line names the columns
/// (lib/docs/formats.md); without it `reading` names the measure, and the numbers are rates, or probabilities if it has
/// years. A probability P in T years is the rate -ln(1 - P)/T. `name`: of the file, for messages.
///
/// Throws base::InputError with line, value and remedy of every fault: names that are not known, a time of the
/// probabilities that is not stated or stated twice, a line without two numbers, an intensity that is not positive or
/// does not rise, a rate that rises, a probability of 1 or more, intensities that are in another unit than their name says,
/// fewer than two points or more than `most_hazard_points`, a text of more than `most_hazard_bytes`.
[[nodiscard]] HazardCurve read_hazard(std::string_view text, const std::string& name,
                                      const HazardReading& reading = {});

}  // namespace rocking
