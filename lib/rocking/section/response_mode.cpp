#include "rocking/section/response_mode.hpp"

#include <array>
#include <charconv>

namespace rocking::section {
namespace {

struct NamedKind {
  ResponseKind kind;
  std::string_view name;
};

/// Every kind but `periodic`, whose modes are named by their numbers.
constexpr std::array<NamedKind, 4> named_kinds{{{ResponseKind::chaotic, "chaotic"},
                                                {ResponseKind::overturned, "overturned"},
                                                {ResponseKind::rest, "rest"},
                                                {ResponseKind::unresolved, "unresolved"}}};
static_assert(named_kinds.size() == static_cast<std::size_t>(ResponseKind::unresolved), "a kind has no name");

}  // namespace

std::string to_string(const ResponseMode& mode) {
  for (const auto& [kind, name] : named_kinds) {
    if (kind == mode.kind) return std::string(name);
  }
  return std::string("(") + std::to_string(mode.rocks) + "," + std::to_string(mode.periods) + ")";
}

std::optional<ResponseMode> response_mode_named(std::string_view name) {
  for (const auto& [kind, known] : named_kinds) {
    if (known == name) return ResponseMode{.kind = kind};
  }
  if (!name.starts_with('(')) return std::nullopt;
  ResponseMode mode{.kind = ResponseKind::periodic};
  const char* const end = name.data() + name.size();
  const auto rocks = std::from_chars(name.data() + 1, end, mode.rocks);
  if (rocks.ptr == end) return std::nullopt;
  std::from_chars(rocks.ptr + 1, end, mode.periods);
  return to_string(mode) == name ? std::optional(mode) : std::nullopt;
}

std::string response_mode_pattern() {
  std::string pattern = "^(\\([0-9]{1,10},[0-9]{1,10}\\)";
  for (const auto& [kind, name] : named_kinds) (pattern += '|') += name;
  return pattern + ")$";
}

}  // namespace rocking::section
