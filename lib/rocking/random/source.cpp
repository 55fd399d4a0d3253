#include "rocking/random/source.hpp"

namespace rocking::random {

std::string_view to_string(Source source) {
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
  }
  return {};
}

}  // namespace rocking::random
