#include "rocking/base/utf8.hpp"

namespace rocking::base {

std::size_t utf8_length_at(std::string_view text, std::size_t start) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(start);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length == 0 || start + length > text.size()) return 0;
  for (std::size_t i = start + 1; i < start + length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
  }
  if (length < 3) return length;
  const unsigned char second = byte(start + 1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_letter = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return overlong || no_letter ? 0 : length;
}

bool is_utf8(std::string_view text) {
  std::size_t place = 0;
  while (place < text.size()) {
    const std::size_t length = utf8_length_at(text, place);
    if (length == 0) return false;
    place += length;
  }
  return true;
}

std::string direction_control_at(std::string_view text, std::size_t start) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(start);
  const unsigned second = byte(start + 1);
  if (first == 0xd8 && second == 0x9c) return "\\u061c";
  if (first != 0xe2 || (second != 0x80 && second != 0x81)) return "";
  const unsigned value = 0x2000U + ((second & 0x3fU) << 6U) + (byte(start + 2) & 0x3fU);
  const bool is_control = (byte(start + 2) & 0xc0U) == 0x80U &&
                          (value == 0x200eU || value == 0x200fU || (0x202aU <= value && value <= 0x202eU) ||
                           (0x2066U <= value && value <= 0x2069U));
  if (!is_control) return "";
  constexpr char digits[] = "0123456789abcdef";
  return {'\\', 'u', '2', '0', digits[value >> 4U & 15U], digits[value & 15U]};
}

}  // namespace rocking::base
