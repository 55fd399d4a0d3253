#include "rocking/input/header_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>

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

/// Whether a text is a number with its unit, `0.6g`; a power of ten before a unit belongs to that.
bool is_value(std::string_view text) {
  text = without_blanks_before(text);
  return !text.empty() && (std::isdigit(static_cast<unsigned char>(text.front())) != 0 || text.front() == '.') &&
         !text.starts_with("10^") && !text.starts_with("10**") && !text.starts_with("1e") && !text.starts_with("1E");
}

/// `10^-2`, `x10^-2`, `1/100` or `milli`, which a unit may follow.
bool is_power(std::string_view word) {
  if (begins_with_word(word, "milli") || begins_with_word(word, "centi")) return true;
  const std::size_t bar = word.find('/');
  if (bar != std::string_view::npos && is_number_field(word.substr(0, bar)) && is_number_field(word.substr(bar + 1)))
    return true;
  if (word.starts_with('x')) word.remove_prefix(1);
  return word.starts_with("10^") || word.starts_with("10**");
}

/// Whether a word that follows a unit begins a factor: `x`, `*1000`, `/`.
bool begins_factor(std::string_view word) {
  return word == "x" || word == "times" || word.starts_with('*') || (word.starts_with('/') && word.size() > 1) ||
         word.starts_with("\u00D7");
}

/// Whether a factor stands at the beginning of `text`, behind a unit in brackets: `/10`, ` x 1000`.
bool is_multiplied(std::string_view text) {
  text = without_blanks_before(text);
  constexpr std::array<std::string_view, 5> signs{"*", "/", "x", "times", "\u00D7"};
  const auto* const sign =
      std::ranges::find_if(signs, [text](std::string_view each) { return text.starts_with(each); });
  if (sign == signs.end()) return false;
  text = without_blanks_before(text.substr(sign->size()));
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
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

std::vector<std::string_view> in_brackets(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t open = line.find_first_of("([{"); open != std::string_view::npos;
       open = line.find_first_of("([{", open + 1)) {
    const std::size_t close = line.find_first_of(")]}", open);
    if (close == std::string_view::npos) break;
    found.push_back(line.substr(open + 1, close - open - 1));
  }
  return found;
}

std::vector<StatedUnit> units_among_words(std::string_view line) {
  std::vector<StatedUnit> found;
  const auto take = [&found](std::string_view text) {
    const WrittenUnit unit = unit_written(text);
    const bool is_with_second =
        unit.kind == UnitKind::acceleration || unit.kind == UnitKind::velocity || has_factor(unit.kind);
    if (is_with_second && !is_value(text)) found.push_back({text, unit});
    return is_with_second;
  };
  std::string rest(line);
  for (const std::string_view text : in_brackets(line)) {
    if (!take(text)) continue;
    const auto place = static_cast<std::size_t>(text.data() - line.data());
    std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(place), text.size(), ' ');
    if (is_multiplied(line.substr(place + text.size() + 1)))
      found.push_back({trimmed(line.substr(place - 1)), {.kind = UnitKind::scaled}});
  }
  std::vector<std::string_view> words;
  split_fields(rest, words);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && is_number_field(words[i - 1])) continue;
    const auto place = static_cast<std::size_t>(words[i].data() - rest.data());
    std::size_t first = place, last = place + words[i].size();
    if (i > 0 && is_power(words[i - 1])) first = static_cast<std::size_t>(words[i - 1].data() - rest.data());
    const bool goes_on = i + 1 < words.size() && begins_factor(words[i + 1]);
    if (goes_on) last = static_cast<std::size_t>(words.back().data() - rest.data()) + words.back().size();
    const std::string_view alone = line.substr(place, words[i].size());
    if ((goes_on || first < place) && unit_written(alone).kind == UnitKind::acceleration) {
      const WrittenUnit unit = unit_written(line.substr(first, last - first));
      found.push_back({line.substr(first, last - first),
                       unit.kind == UnitKind::unknown ? WrittenUnit{.kind = UnitKind::scaled} : unit});
    } else {
      static_cast<void>(take(alone));
    }
  }
  return found;
}

}  // namespace rocking
