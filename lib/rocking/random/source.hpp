#pragma once

#include <cstdint>
#include <string_view>

namespace rocking::random {

/// What a draw is for. Part of the counter, so that no two purposes ever share a draw.
///
/// The numbers are part of the format `rocking.draws/1`: a new purpose takes the next one, none is ever given again.
enum class Source : std::uint8_t {
  static_friction = 1,
  kinetic_friction = 2,
  restitution = 3,
  amplitude = 4,
  phase = 5,
  tilt = 6,
  tilt_rate = 7,
  slip_rate = 8,
  check_normal = 9,
};

[[nodiscard]] std::string_view to_string(Source source);

}  // namespace rocking::random
