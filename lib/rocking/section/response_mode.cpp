#include "rocking/section/response_mode.hpp"

#include <charconv>

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

std::optional<ResponseMode> response_mode_named(std::string_view name) {
  for (const ResponseKind kind :
       {ResponseKind::chaotic, ResponseKind::overturned, ResponseKind::rest, ResponseKind::unresolved}) {
    if (to_string(ResponseMode{.kind = kind}) == name) return ResponseMode{.kind = kind};
  }
  if (!name.starts_with('(')) return std::nullopt;
  ResponseMode mode{.kind = ResponseKind::periodic};
  const char* const end = name.data() + name.size();
  const auto rocks = std::from_chars(name.data() + 1, end, mode.rocks);
  if (rocks.ptr == end) return std::nullopt;
  std::from_chars(rocks.ptr + 1, end, mode.periods);
  return to_string(mode) == name ? std::optional(mode) : std::nullopt;
}

}  // namespace rocking::section
