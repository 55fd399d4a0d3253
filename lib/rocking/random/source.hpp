#pragma once

#include <cstdint>
#include <string_view>

namespace rocking::random {

/// Purpose of a draw. It is part of the counter, so that two purposes never share a draw.
///
/// The values are part of the format `rocking.draws/1`. A new purpose takes the next value; a value is never reused.
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
  block_width = 10,
  block_height = 11,
  fragility_bootstrap = 12,
  rare_choice = 13,
};

[[nodiscard]] constexpr std::string_view to_string(Source source) {
  switch (source) {
    case Source::static_friction: return "static_friction";
    case Source::kinetic_friction: return "kinetic_friction";
    case Source::restitution: return "restitution";
    case Source::amplitude: return "amplitude";
    case Source::phase: return "phase";
    case Source::tilt: return "tilt";
    case Source::tilt_rate: return "tilt_rate";
    case Source::slip_rate: return "slip_rate";
    case Source::check_normal: return "check_normal";
    case Source::block_width: return "block_width";
    case Source::block_height: return "block_height";
    case Source::fragility_bootstrap: return "fragility_bootstrap";
    case Source::rare_choice: return "rare_choice";
  }
  return {};
}

/// Whether draws for this purpose are made again and again along a motion, rather than once at its start or apart from it.
[[nodiscard]] constexpr bool is_drawn_along_the_way(Source source) {
  switch (source) {
    case Source::static_friction:
    case Source::kinetic_friction:
    case Source::restitution:
    case Source::amplitude: return true;
    case Source::phase:
    case Source::tilt:
    case Source::tilt_rate:
    case Source::slip_rate:
    case Source::check_normal:
    case Source::block_width:
    case Source::block_height:
    case Source::fragility_bootstrap:
    case Source::rare_choice: break;
  }
  return false;
}

}  // namespace rocking::random
