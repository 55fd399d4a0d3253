#include "rocking/input/header_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>

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

constexpr std::string_view blank_characters = " \t\r";

std::string_view without_blanks_before(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blank_characters), text.size()));
  return text;
}

/// `text` behind words that stand between `units` and the unit.
std::string_view behind_connectors(std::string_view text) {
  constexpr std::array<std::string_view, 6> connectors{"of", "are", "is", "in", "acceleration", "accelerations"};
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r:=-"), text.size()));
    const auto is_next = [text](std::string_view word) { return begins_with_word(text, word); };
    const auto word = std::ranges::find_if(connectors, is_next);
    if (word == connectors.end()) return text;
    const std::string_view rest = without_blanks_before(text.substr(word->size()));
    if (rest.empty() || rest.front() == '/') return text;  // a unit: in / sec / sec
    text = rest;
  }
}

/// Whether a formula goes on with `text`, so that what stands before it is not the whole unit.
bool goes_on_as_formula(std::string_view text) {
  text = without_blanks_before(text);
  if (text.empty()) return false;
  if (std::isdigit(static_cast<unsigned char>(text.front())) != 0) return true;
  if (std::string_view("*/^%+").find(text.front()) != std::string_view::npos) return true;
  return begins_with_word(text, "x") || begins_with_word(text, "times") || begins_with_word(text, "per");
}

/// The unit at the beginning of `text`: the longest one of its first words.
StatedUnit unit_at(std::string_view text) {
  text = text.substr(0, longest_unit);
  constexpr std::size_t most_words = 6;  // in / sec / sec is the longest
  StatedUnit longest{.text = text.substr(0, text.find_first_of(blank_characters)), .unit = {}};
  std::size_t end = 0;
  for (std::size_t i = 0; i < most_words && end < text.size(); ++i) {
    const std::size_t begin = std::min(text.find_first_not_of(blank_characters, end), text.size());
    end = std::min(text.find_first_of(" \t\r,;", begin), text.size());
    const std::string_view words = text.substr(0, end);
    const WrittenUnit unit = unit_written(words);
    const bool is_whole = unit.kind != UnitKind::unknown && !goes_on_as_formula(text.substr(end));
    if (is_whole) longest = {.text = words, .unit = unit};
    if (end < text.size() && (text[end] == ',' || text[end] == ';')) break;
    if (words.ends_with('.') || words.ends_with(')')) break;
  }
  return longest;
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

std::vector<StatedUnit> units_stated(std::string_view line) {
  std::vector<StatedUnit> stated;
  for (const std::string_view word : {"units", "unit"}) {
    std::string_view rest = line;
    for (auto place = word_place(rest, word); place; place = word_place(rest, word)) {
      rest = behind_connectors(rest.substr(*place + word.size()));
      stated.push_back(unit_at(rest));
    }
  }
  return stated;
}

std::vector<StatedUnit> units_among_words(std::string_view line) {
  std::vector<StatedUnit> found;
  std::vector<std::string_view> words;
  split_fields(line, words);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const WrittenUnit unit = unit_written(words[i]);
    const bool is_with_second = unit.kind == UnitKind::acceleration || unit.kind == UnitKind::velocity;
    if (is_with_second && (i == 0 || !is_number_field(words[i - 1]))) found.push_back({words[i], unit});
  }
  return found;
}

}  // namespace rocking
