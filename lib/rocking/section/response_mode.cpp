#include "rocking/section/response_mode.hpp"

namespace rocking::section {

std::string to_string(const ResponseMode& mode) {
  switch (mode.kind) {
    case ResponseKind::periodic:
      return std::string("(") + std::to_string(mode.rocks) + "," + std::to_string(mode.periods) + ")";
    case ResponseKind::chaotic: return "chaotic";
    case ResponseKind::overturned: return "overturned";
    case ResponseKind::rest: return "rest";
    case ResponseKind::unresolved: return "unresolved";
  }
  return "";
}

}  // namespace rocking::section
