#include "rocking/input/header_words.hpp"

#include <cctype>

#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

char lower_case(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool stands_at(std::string_view line, std::size_t place, std::string_view word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lower_case(line[place + i]) != word[i]) return false;
  }
  const std::size_t end = place + word.size();
  return (place == 0 || !is_word_character(line[place - 1])) && (end == line.size() || !is_word_character(line[end]));
}

}  // namespace

std::optional<std::size_t> word_place(std::string_view line, std::string_view word) {
  for (std::size_t place = 0; place + word.size() <= line.size(); ++place) {
    if (stands_at(line, place, word)) return place;
  }
  return std::nullopt;
}

bool begins_with_word(std::string_view line, std::string_view word) {
  return line.size() >= word.size() && stands_at(line, 0, word);
}

std::optional<std::string_view> number_after(std::string_view line, std::string_view word) {
  const auto place = word_place(line, word);
  if (!place) return std::nullopt;
  line.remove_prefix(*place + word.size());
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t' || line.front() == '=' || line.front() == ':')) {
    line.remove_prefix(1);
  }
  const std::string_view field = line.substr(0, line.find_first_of(" \t\r,;"));
  if (!is_number_field(field)) return std::nullopt;
  return field;
}

}  // namespace rocking
