#include "rocking/text/seed_text.hpp"

#include <charconv>
#include <system_error>

namespace rocking {

std::optional<std::uint64_t> seed_from_text(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  std::uint64_t seed = 0;
  const char* const all_read = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), all_read, seed, hexadecimal ? 16 : 10);
  if (error != std::errc() || end != all_read) return std::nullopt;
  return seed;
}

std::string seed_text(std::uint64_t seed) {
  char digits[16];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, seed, 16);
  static_cast<void>(error);  // 16 digits hold every 64-bit number
  return "0x" + std::string(digits, end);
}

}  // namespace rocking
