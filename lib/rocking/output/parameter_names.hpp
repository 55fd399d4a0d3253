#pragma once

#include <span>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Parts of file names that tell the parts of a sweep from each other, one for each list of parameters: the last key
/// and the value of each parameter, such as `static_0.35_amplitude_4.2`; where two parameters have the same last key,
/// the last two keys. They consist of letters, digits, `.`, `+`, `-` and `_`, have at most 120 bytes, and no two are
/// equal, also where upper and lower case count as equal; the later one of two gets a number. All lists have the same
/// pointers.
[[nodiscard]] std::vector<std::string> parameter_names(std::span<const std::vector<Parameter>> parts);

}  // namespace rocking
