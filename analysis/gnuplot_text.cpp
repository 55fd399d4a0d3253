#include "analysis/gnuplot_text.hpp"

#include <algorithm>
#include <cstdint>

#include "rocking/output/text_table.hpp"

namespace rocking::analysis {
namespace {

constexpr std::string_view plain_marks = " ,.;:?()[]/+-*=_";
constexpr std::string_view replacement = "\xEF\xBF\xBD";       // U+FFFD
constexpr std::string_view ellipsis = "\xE2\x80\xA6";          // U+2026
constexpr std::string_view zero_width_space = "\xE2\x80\x8B";  // U+200B

/// A character and its length in bytes; length 1 and no value if the bytes are not valid UTF-8 (RFC 3629).
struct Character {
  std::size_t length = 1;
  std::uint32_t value = 0;
  bool valid = false;
};

std::uint32_t byte_of(std::string_view text, std::size_t place) {
  return place < text.size() ? static_cast<unsigned char>(text[place]) : 0U;
}

Character character_at(std::string_view text, std::size_t place) {
  const std::uint32_t first = byte_of(text, place);
  if (first < 0x80) return {.length = 1, .value = first, .valid = true};
  const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  constexpr std::uint32_t least[]{0x80, 0x800, 0x10000};  // of 2, 3, 4 bytes
  if (first < 0xc2 || first > 0xf4) return {};
  std::uint32_t value = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const std::uint32_t next = byte_of(text, place + i);
    if ((next & 0xc0U) != 0x80U) return {};
    value = (value << 6U) | (next & 0x3fU);
  }
  const bool surrogate = 0xd800 <= value && value < 0xe000;
  if (value < least[length - 2] || value > 0x10ffff || surrogate) return {};
  return {.length = length, .value = value, .valid = true};
}

bool is_control(std::uint32_t character) { return character < 0x20 || (0x7f <= character && character < 0xa0); }

/// Characters that need no escape within gnuplot's double quotes, wherever the string is used.
bool is_plain(char c) {
  const bool letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
  return letter || (static_cast<unsigned char>(c) & 0x80U) != 0 || plain_marks.find(c) != std::string_view::npos;
}

std::string octal(char c) {
  const auto code = static_cast<unsigned char>(c);
  return {'\\', static_cast<char>('0' + code / 64), static_cast<char>('0' + code / 8 % 8),
          static_cast<char>('0' + code % 8)};
}

/// gnuplot's SVG output interprets `&#x` as a character reference and does not escape `]]>`, which XML forbids: both
/// are broken up.
std::string safe_in_svg(std::string text) {
  for (const std::string_view sequence : {"&#x", "]]>"}) {
    for (std::size_t place = text.find(sequence); place != std::string::npos; place = text.find(sequence, place)) {
      text.insert(place + sequence.size() - 1, zero_width_space);
    }
  }
  return text;
}

/// `text` with `mark` inserted before each character that is in `special`.
std::string marked(std::string_view text, std::string_view special, char mark) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += mark;
    result += c;
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const Character character = character_at(text, place);
    const bool forbidden = !character.valid || character.value == 0xfffe || character.value == 0xffff;
    if (forbidden) {
      result += replacement;
    } else if (is_control(character.value)) {
      result += ' ';
    } else {
      result += text.substr(place, character.length);
    }
    place += character.length;
  }
  return result;
}

std::string cut(const std::string& text, std::size_t most) {
  if (letters_in(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t count = 1; count < most; ++count) end += character_at(text, end).length;
  return text.substr(0, end).append(ellipsis);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = cut(text.substr(start, end - start), most);
    const bool fits = letters_in(lines.back()) + 1 + letters_in(word) <= most;
    if (!lines.back().empty() && !fits) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    start = end + 1;
  }
  return lines;
}

std::string gnuplot_quoted(std::string_view text) {
  std::string result = "\"";
  bool after_octal = false;
  for (const char c : safe_in_svg(printable(text))) {
    // gnuplot reads a digit after an octal number as part of that number.
    const bool misread = after_octal && '0' <= c && c <= '9';
    after_octal = misread || !is_plain(c);
    result += after_octal ? octal(c) : std::string(1, c);
  }
  return result + '"';
}

std::string without_marks(std::string_view text) { return marked(printable(text), "\\^_{}@&~", '\\'); }

std::string without_formats(std::string_view text) { return marked(printable(text), "%", '%'); }

}  // namespace rocking::analysis
