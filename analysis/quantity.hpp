#pragma once

#include <string>

#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Mean of a number or a law as it stands in an experiment file.
[[nodiscard]] double mean_of(const Json& quantity);

/// `0.5`, `0.4 to 0.6 (drawn)` or `0.5 (drawn, standard deviation 0.05)`.
[[nodiscard]] std::string spoken_quantity(const Json& quantity);

}  // namespace rocking::analysis
