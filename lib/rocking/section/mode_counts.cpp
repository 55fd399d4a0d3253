#include "rocking/section/mode_counts.hpp"

#include <algorithm>
#include <charconv>

namespace rocking::section {

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
