#include "rocking/input/record_component.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <vector>

#include "rocking/input/header_words.hpp"
#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

constexpr std::array<std::string_view, 12> vertical_words{"UP",  "UD", "VER",  "VERT",    "VERTICAL", "VRT",
                                                          "DWN", "DN", "DOWN", "UP-DOWN", "U-D",      "UPDOWN"};
constexpr std::array<std::string_view, 2> vertical_letters{"V", "Z"};
constexpr std::array<std::string_view, 19> horizontal_words{"N",     "S",     "E",    "W",    "NS",        "SN", "EW",
                                                            "WE",    "N-S",   "E-W",  "H1",   "H2",        "L",  "T",
                                                            "NORTH", "SOUTH", "EAST", "WEST", "HORIZONTAL"};

bool is_among(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The orientation of a SEED code: `Z` of `HNZ`; absent: it is none. Band and instrument are those of strong and broad motion.
std::optional<char> seed_orientation(std::string_view word) {
  const bool is_code = word.size() == 3 && std::string_view("BEHLMS").find(word[0]) != std::string_view::npos &&
                       std::string_view("HNLG").find(word[1]) != std::string_view::npos &&
                       std::string_view("ZNE123RT").find(word[2]) != std::string_view::npos;
  return is_code ? std::optional(word[2]) : std::nullopt;
}

bool is_vertical(std::string_view word) {
  return is_among(vertical_words, word) || is_among(vertical_letters, word) || seed_orientation(word) == 'Z';
}

/// An azimuth in degrees, `N26W`, or a word.
bool is_horizontal(std::string_view word) {
  if (is_among(horizontal_words, word)) return true;
  if (const auto orientation = seed_orientation(word)) return *orientation != 'Z' && *orientation != '3';
  const bool is_bearing =
      word.size() > 2 && (word.front() == 'N' || word.front() == 'S') && (word.back() == 'E' || word.back() == 'W');
  if (is_bearing) word = word.substr(1, word.size() - 2);
  return !word.empty() && word.size() <= 3 && std::ranges::all_of(word, is_digit);
}

/// By which names of a component are compared.
std::string plain_component(std::string_view name) {
  std::string plain = upper_case(name);
  std::erase_if(plain, [](char c) { return c == ' '; });
  for (const std::string_view ending : {"DEGREES", "DEG"}) {
    if (plain.ends_with(ending)) plain.erase(plain.size() - ending.size());
  }
  if (plain.empty() || !std::ranges::all_of(plain, is_digit)) return plain;
  plain.erase(0, std::min(plain.find_first_not_of('0'), plain.size()));
  return plain.empty() ? "360" : plain;
}

/// The words of a line that consist of letters, digits and hyphens.
std::vector<std::string> words_in(std::string_view line) {
  std::vector<std::string> words(1);
  for (const char c : upper_case(line)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

std::string beside_component(std::string_view line) {
  const std::vector<std::string> words = words_in(line);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != "COMPONENT" && words[i] != "COMP") continue;
    const bool is_numbered = i + 1 < words.size() && words[i + 1].size() == 1 && is_digit(words[i + 1].front());
    if (is_numbered && std::ranges::find(words, "VERTICAL") != words.end())
      return "VERTICAL";  // component 3 (vertical)
    if (i + 1 < words.size() && (is_vertical(words[i + 1]) || is_horizontal(words[i + 1]))) return words[i + 1];
    if (i > 0 && (is_vertical(words[i - 1]) || is_horizontal(words[i - 1]))) return words[i - 1];
  }
  return {};
}

/// Takes the ending off a name and returns it; empty if there is none.
std::string_view take_ending(std::string_view& name) {
  const std::size_t point = name.rfind('.');
  if (point == std::string_view::npos || point == 0) return {};
  const std::string_view ending = name.substr(point + 1);
  name = name.substr(0, point);
  return ending;
}

/// The word by which a name of a file, in capital letters, says that it is of a vertical component; empty if none.
std::string_view vertical_word_in(std::string_view name) {
  constexpr std::array<std::string_view, 6> endings{"UD", "UD1", "UD2", "UP", "VER", "VRT"};
  constexpr std::array<std::string_view, 7> of_data{"AT2", "TXT", "DAT", "CSV", "ASC", "ACC", "TH"};
  std::string_view stem = name.substr(name.rfind('/') + 1);
  std::string_view rest = stem;
  for (std::string_view ending = take_ending(rest); !ending.empty(); ending = take_ending(rest)) {
    if (is_among(endings, ending)) return ending;
    if (!is_among(of_data, ending)) break;
    stem = rest;
  }
  const std::size_t separator = stem.find_last_of("-_. ");
  const std::string_view last = stem.substr(separator == std::string_view::npos ? 0 : separator + 1);
  if (is_among(vertical_words, last)) return last;
  if (separator != std::string_view::npos && is_among(vertical_letters, last)) return last;
  const std::string_view behind_digit = last.substr(std::min(last.find_last_of("0123456789") + 1, last.size()));
  if (behind_digit.size() < last.size() && is_among(vertical_words, behind_digit)) return behind_digit;
  return {};
}

/// The words of the last part of a path, in capital letters.
std::vector<std::string> words_of_name(std::string_view path) {
  std::string name(path.substr(path.rfind('/') + 1));
  std::ranges::replace(name, '-', '.');
  return words_in(name);
}

/// The only SEED code among words; empty: none or several.
std::string seed_code_among(const std::vector<std::string>& words) {
  std::string only;
  for (const std::string& word : words) {
    if (!seed_orientation(word) || word == only) continue;
    if (!only.empty()) return {};
    only = word;
  }
  return only;
}

}  // namespace

std::string component_in(std::string_view line) {
  if (std::string word = beside_component(line); !word.empty()) return word;
  const std::size_t comma = line.rfind(',', std::min(line.find('('), line.size()));
  if (comma == std::string_view::npos) return {};
  const std::string_view field = line.substr(comma + 1);
  const std::string last = upper_case(trimmed(field.substr(0, field.find('('))));
  return is_vertical(last) || is_horizontal(last) ? last : std::string();
}

std::string component_word_in(std::string_view line) {
  if (std::string word = beside_component(line); !word.empty()) return word;
  // Codes are in capital letters, which words such as `she` are not.
  const std::string code = seed_code_among(words_in(line));
  return line.find(code) == std::string_view::npos ? std::string() : code;
}

bool is_vertical_component(std::string_view component) {
  const std::string upper = upper_case(component);
  return is_vertical(upper) || (upper.size() == 3 && upper.ends_with('Z'));
}

bool is_same_component(std::string_view one, std::string_view other) {
  return plain_component(one) == plain_component(other);
}

std::optional<std::string> why_vertical(const GroundMotion& motion) {
  const std::string& component = motion.component;
  if (is_vertical_component(component)) return "by its header (" + component + ')';
  const std::string name = upper_case(motion.name);
  const std::string_view word = vertical_word_in(name);
  const bool does_header_decide = is_among(vertical_letters, word) && !component.empty();
  if (!word.empty() && !does_header_decide) return "by its name (" + std::string(word) + ')';
  const std::string channel = seed_code_among(words_of_name(name));
  if (seed_orientation(channel) == 'Z') return "by its name (" + channel + ')';
  return std::nullopt;
}

std::optional<std::string> why_horizontal(const GroundMotion& motion) {
  if (!motion.component.empty()) {
    if (!is_horizontal(upper_case(motion.component))) return std::nullopt;
    return "by its header (" + motion.component + ')';
  }
  const std::vector<std::string> words = words_of_name(motion.name);
  constexpr std::array<std::string_view, 6> endings{"EW", "NS", "EW1", "EW2", "NS1", "NS2"};
  const auto found = std::ranges::find_if(words, [&](const std::string& word) { return is_among(endings, word); });
  const std::string word = found == words.end() ? seed_code_among(words) : *found;
  if (word.empty() || is_vertical(word)) return std::nullopt;
  return "by its name (" + word + ')';
}

bool is_of_borehole(const GroundMotion& motion) {
  constexpr std::array<std::string_view, 3> endings{"NS1", "EW1", "UD1"};
  return motion.is_of_borehole || std::ranges::any_of(words_of_name(motion.name),
                                                      [&](const std::string& word) { return is_among(endings, word); });
}

}  // namespace rocking
