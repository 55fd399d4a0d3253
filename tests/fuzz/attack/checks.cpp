#include "fuzz/attack/checks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <vector>

namespace rocking::fuzz {
namespace {

/// Length in bytes of the UTF-8 character at `place`; 0 if there is none.
std::size_t length_of_sign(std::string_view text, std::size_t place) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(place);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length == 0 || place + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(place + i) & 0xc0U) != 0x80) return 0;
  }
  return length;
}

bool is_control(std::string_view sign) {
  const auto first = static_cast<unsigned char>(sign[0]);
  if (sign.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f;
  return first == 0xc2 && static_cast<unsigned char>(sign[1]) < 0xa0;  // U+0080 to U+009F
}

constexpr std::array<std::string_view, 9> without_end{"meta", "br",  "link", "input", "img",
                                                      "hr",   "col", "wbr",  "source"};

/// Elements whose text is not parsed as HTML.
bool is_raw(std::string_view name) { return name == "script" || name == "style"; }

std::string around(std::string_view page, std::size_t place) {
  return " at byte " + std::to_string(place) + ": " + std::string(page.substr(place, 60));
}

/// End of the tag that begins at `place`, quoted attributes skipped; npos if there is none.
std::size_t end_of_tag(std::string_view page, std::size_t place) {
  char quote = 0;
  for (; place < page.size(); ++place) {
    const char sign = page[place];
    if (quote != 0) {
      if (sign == quote) quote = 0;
    } else if (sign == '"' || sign == '\'') {
      quote = sign;
    } else if (sign == '>') {
      return place;
    }
  }
  return std::string_view::npos;
}

std::string_view name_at(std::string_view page, std::size_t place) {
  std::size_t end = place;
  while (end < page.size() &&
         (std::isalnum(static_cast<unsigned char>(page[end])) != 0 || page[end] == '-' || page[end] == ':'))
    ++end;
  return page.substr(place, end - place);
}

/// Whether the `&` begins a reference such as `&amp;`.
bool is_reference(std::string_view page, std::size_t place) {
  const std::size_t end = page.find(';', place);
  if (end == std::string_view::npos || end - place > 10 || end == place + 1) return false;
  return std::all_of(page.begin() + static_cast<std::ptrdiff_t>(place) + 1,
                     page.begin() + static_cast<std::ptrdiff_t>(end),
                     [](unsigned char sign) { return std::isalnum(sign) != 0 || sign == '#'; });
}

}  // namespace

std::string control_character_in(std::string_view text) {
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = length_of_sign(text, place);
    if (length > 0 && is_control(text.substr(place, length))) {
      std::array<char, 64> words{};
      std::snprintf(words.data(), words.size(), "byte 0x%02x at %zu", static_cast<unsigned char>(text[place]), place);
      return words.data();
    }
    place += std::max<std::size_t>(length, 1);
  }
  return {};
}

bool is_utf8(std::string_view text) {
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = length_of_sign(text, place);
    if (length == 0) return false;
    place += length;
  }
  return true;
}

std::string damage_of_page(std::string_view page) {
  std::vector<std::string_view> open;
  for (std::size_t place = 0; place < page.size();) {
    if (page[place] == '&' && !is_reference(page, place)) return "`&` that is none" + around(page, place);
    if (page[place] != '<') {
      ++place;
      continue;
    }
    if (page.substr(place).starts_with("<!--")) {
      const std::size_t end = page.find("-->", place);
      if (end == std::string_view::npos) return "a comment without end" + around(page, place);
      place = end + 3;
      continue;
    }
    const std::size_t end = end_of_tag(page, place);
    if (end == std::string_view::npos) return "a tag without end" + around(page, place);
    const bool closes = place + 1 < page.size() && page[place + 1] == '/';
    const std::string_view name = name_at(page, place + (closes ? 2 : 1));
    if (page[place + 1] == '!' || page[place + 1] == '?') {  // <!doctype html>
    } else if (name.empty()) {
      return "`<` that is none" + around(page, place);
    } else if (closes) {
      if (open.empty() || open.back() != name) return "an end that nothing began" + around(page, place);
      open.pop_back();
    } else if (page[end - 1] != '/' && std::ranges::find(without_end, name) == without_end.end()) {
      if (is_raw(name)) {
        const std::size_t close = page.find("</" + std::string(name) + ">", end);
        if (close == std::string_view::npos) return "a script or style without end" + around(page, place);
        place = close + name.size() + 3;
        continue;
      }
      open.push_back(name);
    }
    place = end + 1;
  }
  return open.empty() ? std::string() : "not ended: " + std::string(open.back());
}

}  // namespace rocking::fuzz
