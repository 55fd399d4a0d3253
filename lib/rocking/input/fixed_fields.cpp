#include "rocking/input/fixed_fields.hpp"

#include <algorithm>
#include <charconv>

namespace rocking {
namespace {

/// Takes a whole number off the front of `text`; 0 if there is none.
std::size_t take_whole(std::string_view& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool has_field_beyond(std::string_view line, std::size_t width) {
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    if (end - begin > width) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

std::optional<FieldFormat> field_format_in(std::string_view line) {
  constexpr std::size_t most = 200;
  for (std::size_t place = line.find('('); place != std::string_view::npos; place = line.find('(', place + 1)) {
    std::string_view text = line.substr(place + 1);
    FieldFormat format{.count = take_whole(text)};
    if (text.empty() || std::string_view("IFEGDifegd").find(text.front()) == std::string_view::npos) continue;
    text.remove_prefix(1);
    format.width = take_whole(text);
    if (format.count > 0 && format.count <= most && format.width > 0 && format.width <= most) return format;
  }
  return std::nullopt;
}

std::string parted_fields(std::string_view text, std::size_t width) {
  std::string parted;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    if (has_field_beyond(line, width)) {
      for (std::size_t i = 0; i < line.size(); i += width) (parted += line.substr(i, width)) += ' ';
    } else {
      parted += line;
    }
    parted += '\n';
  }
  return parted;
}

std::vector<std::string_view> take_fields(std::string_view& text, std::size_t lines, FieldFormat format,
                                          LineProblems& problems) {
  std::vector<std::string_view> fields;
  for (std::size_t i = 0; i < lines; ++i) {
    const std::string_view line = problems.next_line(text);
    for (std::size_t k = 0; k < format.count; ++k) {
      fields.push_back(trimmed(line.substr(std::min(k * format.width, line.size()), format.width)));
    }
  }
  return fields;
}

bool is_line_of_numbers(std::string_view line) {
  constexpr std::string_view of_numbers = "0123456789+-.eEdD, \t\r";
  return line.find_first_of("0123456789") != std::string_view::npos &&
         line.find_first_not_of(of_numbers) == std::string_view::npos;
}

std::string_view take_lines(std::string_view& text, std::size_t lines, LineProblems& problems) {
  const std::string_view whole = text;
  for (std::size_t i = 0; i < lines && !text.empty(); ++i) static_cast<void>(problems.next_line(text));
  return whole.substr(0, whole.size() - text.size());
}

}  // namespace rocking
