#include "rocking/section/response_mode.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace rocking::section {
namespace {

struct NamedKind {
  ResponseKind kind;
  std::string_view name;
  std::string_view meaning;
};

/// Every kind but `periodic`, whose modes are named by their numbers.
constexpr auto named_kinds = std::to_array<NamedKind>(
    {{ResponseKind::quasi_periodic, "quasi-periodic", "rocks with two frequencies that have no common period"},
     {ResponseKind::chaotic, "chaotic", "rocks without ever repeating"},
     {ResponseKind::overturned, "overturned", "overturns"},
     {ResponseKind::slide, "slide", "slides and stops, without rocking"},
     {ResponseKind::rest, "rest", "does not move, or stops rocking"},
     {ResponseKind::unresolved, "unresolved", "could not be classified"}});
static_assert(named_kinds.size() == static_cast<std::size_t>(ResponseKind::unresolved), "a kind has no name");

}  // namespace

std::string to_string(const ResponseMode& mode) {
  for (const NamedKind& named : named_kinds) {
    if (named.kind == mode.kind) return std::string(named.name);
  }
  return std::string("(") + std::to_string(mode.rocks) + "," + std::to_string(mode.periods) + ")";
}

std::string_view meaning_of(ResponseKind kind) {
  const auto found = std::ranges::find(named_kinds, kind, &NamedKind::kind);
  return found == named_kinds.end() ? std::string_view() : found->meaning;
}

std::optional<ResponseMode> response_mode_named(std::string_view name) {
  for (const NamedKind& named : named_kinds) {
    if (named.name == name) return ResponseMode{.kind = named.kind};
  }
  if (!name.starts_with('(')) return std::nullopt;
  ResponseMode mode{.kind = ResponseKind::periodic};
  const char* const end = name.data() + name.size();
  const auto rocks = std::from_chars(name.data() + 1, end, mode.rocks);
  if (rocks.ptr == end) return std::nullopt;
  std::from_chars(rocks.ptr + 1, end, mode.periods);
  return to_string(mode) == name ? std::optional(mode) : std::nullopt;
}

std::string response_mode_words() {
  std::string words;
  for (const NamedKind& named : named_kinds) (words += words.empty() ? "" : ", ") += named.name;
  return words;
}

std::string response_mode_pattern() {
  std::string pattern = "^(\\([0-9]{1,10},[0-9]{1,10}\\)";
  for (const NamedKind& named : named_kinds) (pattern += '|') += named.name;
  return pattern + ")$";
}

std::uint64_t ModeCounts::total() const {
  std::uint64_t sum = 0;
  for (const auto& [mode, count] : counts_) sum += count;
  return sum;
}

std::string to_string(const ModeCounts& counts) {
  std::string text;
  for (const auto& [mode, count] : counts) {
    if (!text.empty()) text += ' ';
    text += to_string(mode) + '=' + std::to_string(count);
  }
  return text;
}

std::optional<ModeCounts> mode_counts_named(std::string_view text) {
  ModeCounts counts;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view entry = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const auto mode = response_mode_named(std::string(entry.substr(0, equals)));
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(entry.data() + equals + 1, entry.data() + entry.size(), count);
    if (!mode || error != std::errc{} || count == 0) return std::nullopt;
    counts[*mode] = count;
  }
  if (to_string(counts) != text) return std::nullopt;  // another spelling or order
  return counts;
}

}  // namespace rocking::section
