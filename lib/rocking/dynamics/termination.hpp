#pragma once

#include <cstdint>
#include <string_view>

namespace rocking::dynamics {

/// Why a realisation ended.
enum class Termination : std::uint8_t {
  reached_horizon,
  overturned,  ///< abs(theta) reached pi/2
  painleve,    ///< D <= 0, or 1 + 3q <= 0 in an impact: the model has no answer
  stopped,     ///< more events or steps than a budget allows
};

[[nodiscard]] std::string_view to_string(Termination termination);

}  // namespace rocking::dynamics
