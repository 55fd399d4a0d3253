#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rocking::dynamics {

/// Why a realisation ended.
enum class Termination : std::uint8_t {
  reached_horizon,
  overturned,  ///< abs(theta) reached pi/2
  painleve,    ///< D <= 0, or 1 + 3q <= 0 in an impact: the model has no solution
  stopped,     ///< more events or steps than a budget allows
};

inline constexpr std::array terminations{Termination::reached_horizon, Termination::overturned, Termination::painleve,
                                         Termination::stopped};

[[nodiscard]] std::string_view to_string(Termination termination);

/// The termination with this name; empty if there is none.
[[nodiscard]] std::optional<Termination> termination_named(std::string_view name);

}  // namespace rocking::dynamics
