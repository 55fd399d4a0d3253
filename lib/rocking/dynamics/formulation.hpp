#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// Inertia in the slip equations. `edge` is Jeong & Yang's Eq. 7 as printed; energy does not balance with it.
enum class SlideInertia : std::uint8_t { centroidal, edge };

/// When an impact slips. `signed_ratio` (spelled `signed`) is Jeong & Yang's Eq. 26 without absolute values.
enum class ImpactSlipRule : std::uint8_t { absolute, signed_ratio };

/// J: inertia over m R^2, 1/3 about the centre of mass, 4/3 about the edge.
[[nodiscard]] constexpr double inertia_ratio(SlideInertia inertia) {
  return inertia == SlideInertia::centroidal ? 1.0 / 3.0 : 4.0 / 3.0;
}

}  // namespace rocking::dynamics
