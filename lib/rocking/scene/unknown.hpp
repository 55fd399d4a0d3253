#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rocking/scene/quantity.hpp"

namespace rocking {

/// Most unknowns of an experiment.
inline constexpr std::size_t most_unknowns = 3;

/// A number of the experiment that counted tests are to determine.
struct Unknown {
  std::string pointer;                           ///< JSON pointer to it
  double from = 0.0;                             ///< smallest value, in the unit of the number
  double to = 1.0;                               ///< largest value, above `from`
  std::optional<Quantity> prior = std::nullopt;  ///< a law with a density; absent: none, or uniform beside others
};

}  // namespace rocking
