#include "rocking/input/lines_above_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "rocking/input/header_words.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/input/record_unit.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

std::string blanked(std::string_view line, std::string_view characters) {
  std::string text(line);
  std::ranges::replace_if(
      text, [characters](char c) { return characters.find(c) != std::string_view::npos; }, ' ');
  return text;
}

/// With blanks in place of what joins a name and its unit: `acc_(cm/s2)`, `acc[g]`.
std::string apart(std::string_view line) { return blanked(line, "()[]{}_:=\"'"); }

bool has_any_word(std::string_view head, std::span<const std::string_view> words) {
  const std::string text = apart(head);
  return std::ranges::any_of(words, [&text](std::string_view word) { return word_place(text, word).has_value(); });
}

/// Whether `g` at this place of a remark is the unit of what is spoken of: between brackets, or behind `in` or `of`.
bool is_stated_letter(std::string_view line, std::size_t place) {
  const std::size_t before = place == 0 ? std::string_view::npos : line.find_last_not_of(" \t", place - 1);
  if (before == std::string_view::npos) return false;
  if (std::string_view("([{").find(line[before]) != std::string_view::npos) return true;
  const std::string_view words = line.substr(0, before + 1);
  return words.ends_with(" in") || words.ends_with(" of") || words == "in" || words == "of";
}

/// Whether what ends at `place` is the label of a number: `PGA [g] = 0.4`.
bool labels_number(std::string_view line, std::size_t place) {
  const std::size_t behind = std::min(line.find_first_not_of(")]} \t:=", place), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t\r,;", behind), line.size());
  return is_number_field(line.substr(behind, end - behind));
}

/// Whether a line states a factor other than 1.
bool states_factor(std::string_view line) {
  constexpr std::array<std::string_view, 8> words{"factor",     "multiplier", "scale",         "multiplied by",
                                                  "divided by", "scaled by",  "normalised by", "normalized by"};
  return std::ranges::any_of(words, [line](std::string_view word) {
    const auto number = number_after(line, word);
    double factor = 1.0;
    if (number) std::from_chars(number->data(), number->data() + number->size(), factor);
    return factor != 1.0;
  });
}

/// Whether a text is likely a unit, known or not.
bool speaks_of_unit(std::string_view text) {
  constexpr std::array<std::string_view, 6> words{"count", "counts", "volt", "volts", "mv", "v"};
  constexpr std::array<std::string_view, 5> squares{"/s", "s2", "^2", "**", "\u00B2"};
  return std::ranges::any_of(squares, [text](auto part) { return text.find(part) != std::string_view::npos; }) ||
         has_any_word(text, words);
}

/// What a line says that the numbers are instead of accelerations: `velocity (cm/s)`; empty: nothing.
std::string_view motion_instead(std::string_view line) {
  const std::string text = apart(line);
  for (const std::string_view word : {"acceleration", "accelerations", "acc", "accel", "ah"}) {
    if (word_place(text, word)) return {};
  }
  for (const StatedUnit& found : units_among_words(text)) {
    if (found.unit.kind == UnitKind::acceleration) return {};
    if (found.unit.kind == UnitKind::velocity) return "velocity";
  }
  if (word_place(text, "velocity") || word_place(text, "vel")) return "velocity";
  return word_place(text, "displacement") || word_place(text, "disp") ? "displacement" : "";
}

/// The heads of columns, between the separators of the line, or between blanks, where brackets belong to what stands before
/// them.
std::vector<std::string_view> heads_of(std::string_view line) {
  std::vector<std::string_view> heads;
  if (line.find_first_of(",;\t") != std::string_view::npos) {
    for (;;) {
      const std::size_t end = line.find_first_of(",;\t");
      heads.push_back(line.substr(0, end));
      if (end == std::string_view::npos) return heads;
      line.remove_prefix(end + 1);
    }
  }
  std::string joined(line);
  for (const std::string_view text : in_brackets(line)) {
    std::fill_n(joined.begin() + (text.data() - line.data()), text.size(), '_');
  }
  std::vector<std::string_view> words;
  split_fields(joined, words);
  for (const std::string_view word : words) {
    const std::string_view here = line.substr(static_cast<std::size_t>(word.data() - joined.data()), word.size());
    const bool is_bracket = std::string_view("([{").find(here.front()) != std::string_view::npos;
    if (is_bracket && !heads.empty()) {
      const char* first = heads.back().data();
      heads.back() = {first, static_cast<std::size_t>(here.data() + here.size() - first)};
    } else {
      heads.push_back(here);
    }
  }
  return heads;
}

/// What the heads of columns say that these are instead of a motion against time; empty: nothing.
std::string_view spectrum_in(const std::vector<std::string_view>& heads) {
  constexpr std::array<std::string_view, 4> of_first{"frequency", "freq", "hz", "period"};
  constexpr std::array<std::string_view, 8> of_second{"sa", "psa", "sv", "psv", "sd", "spectral", "spectrum", "fas"};
  if (heads.size() < 2) return {};
  if (has_any_word(heads[0], std::span(of_first).first(3))) return "a spectrum over frequencies";
  return has_any_word(heads[0], of_first) || has_any_word(heads[1], of_second) ? "a response spectrum" : "";
}

/// How many units of a time a second holds: 1000 for `ms`. The word is no unit of a number, nor the magnitude Ms; in a remark
/// it stands between brackets, or behind `time` or `in`.
std::optional<double> per_second_in(std::string_view line, bool is_head) {
  constexpr std::array<std::string_view, 6> of_ms{"ms",          "msec",         "msecs",
                                                  "millisecond", "milliseconds", "millisekunden"};
  constexpr std::array<std::string_view, 5> of_us{"us", "usec", "microseconds", "\u00B5s", "\u03BCs"};
  constexpr std::array<std::string_view, 4> before{"time", "t", "zeit", "in"};
  const std::string text = is_head ? blanked(apart(line), "/") : apart(line);
  std::vector<std::string_view> words;
  split_fields(text, words);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view here = words[i];
    const auto place = static_cast<std::size_t>(here.data() - text.data());
    const bool is_bracketed = place > 0 && std::string_view("([{").find(line[place - 1]) != std::string_view::npos;
    const bool is_behind = i > 0 && std::ranges::any_of(before, [word = words[i - 1]](std::string_view known) {
                             return word.size() == known.size() && begins_with_word(word, known);
                           });
    if (here == "Ms" || (i > 0 && is_number_field(words[i - 1])) || !(is_head || is_bracketed || is_behind)) continue;
    const auto is_word = [here](std::string_view word) {
      return here.size() == word.size() && begins_with_word(here, word);
    };
    if (std::ranges::any_of(of_ms, is_word)) return 1e3;
    if (std::ranges::any_of(of_us, is_word)) return 1e6;
  }
  return std::nullopt;
}

/// What the head of a column calls it; absent if that is not clear.
std::optional<RecordColumn> called(std::string_view head) {
  constexpr std::array<std::string_view, 8> vertical{"vertical", "vert", "ver", "ud", "up", "z", "av", "dwn"};
  constexpr std::array<std::string_view, 3> time{"time", "t", "zeit"};
  if (has_any_word(head, vertical)) return RecordColumn::vertical;
  if (has_any_word(head, time)) return RecordColumn::time;
  constexpr std::array<std::string_view, 7> horizontal{"horizontal", "hor", "ns", "ew", "ah", "north", "east"};
  if (has_any_word(head, horizontal)) return RecordColumn::horizontal;
  return std::nullopt;
}

constexpr std::size_t most_remarks = 10'000;  // characters

}  // namespace

void LinesAboveColumns::add_units(std::string_view line, bool is_head, Statement& statement) {
  const std::string text = blanked(line, "_:\"'");
  std::vector<StatedUnit> found = units_among_words(text);
  std::erase_if(found, [&](const StatedUnit& unit) {
    const auto place = static_cast<std::size_t>(unit.text.data() - text.data());
    const bool is_letter = unit.unit.kind == UnitKind::acceleration && trimmed(unit.text).size() == 1;
    return !is_head && (labels_number(text, place + unit.text.size()) || (is_letter && !is_stated_letter(text, place)));
  });
  for (const StatedUnit& unit : units_stated(text)) {
    if (unit.unit.kind == UnitKind::unknown && speaks_of_unit(unit.text)) statement.unclear = trimmed(unit.text);
    found.push_back(unit);
  }
  for (const StatedUnit& unit : found) {
    if (has_factor(unit.unit.kind)) statement.unclear = trimmed(unit.text);
    if (unit.unit.kind != UnitKind::acceleration) continue;
    const RecordUnit one = unit.unit.acceleration;
    if (std::ranges::find(statement.units, one) == statement.units.end()) statement.units.push_back(one);
    if (states_factor(text)) statement.unclear = trimmed(line);
  }
}

void LinesAboveColumns::take_text(std::string_view words) {
  if (are_heads_text_) add_units(heads_, false, of_remarks_);
  if (are_heads_text_ && remarks_.size() < most_remarks) remarks_ += heads_ + '\n';
  heads_ = words;
  are_heads_text_ = true;
  other_motion_ = motion_instead(words);
}

void LinesAboveColumns::read(std::string_view text) {
  std::vector<std::string_view> fields;
  bool is_above = true;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    const std::size_t hash = std::min(line.find('#'), line.size());
    if (!is_above && hash == line.size()) continue;
    const std::string_view words = line.substr(0, hash);
    const std::string_view remark = trimmed(line.substr(std::min(hash + 1, line.size())));
    if (is_above) split_fields(words, fields);
    is_above = is_above && (fields.empty() || !is_number_field(fields.front()));
    if (is_above && !fields.empty()) take_text(words);
    if (is_above && fields.empty() && !are_heads_text_ && !remark.empty()) heads_ = remark;
    if (is_above && component_.empty()) component_ = component_word_in(line);
    if (remark.empty()) continue;
    add_units(remark, false, of_remarks_);
    if (remarks_.size() < most_remarks) remarks_ += std::string(remark) + '\n';
  }
  if (are_heads_text_) add_units(heads_, true, of_heads_);
}

std::optional<RecordUnit> LinesAboveColumns::stated_unit() const {
  const Statement& stated = statement();
  if (stated.units.size() != 1 || !stated.unclear.empty()) return std::nullopt;
  return stated.units.front();
}

void LinesAboveColumns::take_head(std::string_view head, RecordColumn column, LineProblems& problems) {
  const auto name = called(head);
  if (name && *name != column && column != RecordColumn::other) {
    problems.reject_file("has the head " + brief(Json(std::string(trimmed(head)))) +
                             " above the column that is taken for \"" + std::string(name_of(column)) + '"',
                         "put the names in \"columns\" in the order of the file");
  }
  if (column == RecordColumn::time) {
    constexpr std::array<std::string_view, 10> longer{"min", "mins", "minute", "minutes", "h",
                                                      "hr",  "hrs",  "hour",   "hours",   "days"};
    times_per_second_ = per_second_in(head, true).value_or(times_per_second_);
    if (has_any_word(blanked(head, "/"), longer)) {
      problems.reject_file("has the head " + brief(Json(std::string(trimmed(head)))) +
                               " above its times, which are read in s or ms only",
                           "give them in s");
    }
  }
  if (column != RecordColumn::horizontal && column != RecordColumn::vertical) return;
  std::vector<std::string_view> texts = in_brackets(head);
  const bool is_word = trimmed(head).find_first_of(" \t") == std::string_view::npos;
  if (texts.empty() && is_word) texts.push_back(head);
  for (const std::string_view text : texts) {
    const WrittenUnit unit = unit_written(text);
    if (!of_heads_.is_empty()) return;
    if (unit.kind == UnitKind::acceleration) of_heads_.units.push_back(unit.acceleration);
    const bool is_unclear = has_factor(unit.kind) || (unit.kind == UnitKind::unknown && speaks_of_unit(text));
    if (is_unclear) of_heads_.unclear = trimmed(text);
  }
}

void LinesAboveColumns::check_unit(std::optional<RecordUnit> asked, LineProblems& problems) {
  const Statement& stated = statement();
  const std::string where = of_heads_.is_empty() ? " in a comment" : " above its numbers";
  if (!stated.unclear.empty()) {
    const std::string found = "states the unit " + brief(Json(stated.unclear)) + where + ", ";
    if (!asked) {
      problems.reject_file(found + "which is not known",
                           "give \"units\", one of " + record_units_in_words() +
                               "; multiply the numbers by their factor first, and correct what is stated");
    } else if (unit_written(stated.unclear).kind == UnitKind::multiple) {
      problems.reject_file(found + "which is not that of \"units\", \"" + std::string(name_of(*asked)) + '"',
                           "multiply the numbers by their factor, and correct what is stated");
    } else {
      warning_ = found + "which is not known; \"units\", " + std::string(name_of(*asked)) + ", is taken for it";
    }
    return;
  }
  std::string list;
  for (const RecordUnit unit : stated.units) list += (list.empty() ? "" : " and ") + std::string(name_of(unit));
  const bool is_asked = asked && std::ranges::find(stated.units, *asked) != stated.units.end();
  if (asked && !stated.units.empty() && !is_asked) {
    problems.reject_file(
        "states the unit " + list + where + ", but \"units\" is \"" + std::string(name_of(*asked)) + '"',
        "omit \"units\", or correct the file");
  } else if (!asked && stated.units.size() > 1) {
    problems.reject_file("names several units" + where + ": " + list, "give \"units\", that of its numbers");
  }
}

void LinesAboveColumns::check(const std::vector<RecordColumn>& columns, std::optional<RecordUnit> asked,
                              LineProblems& problems) {
  if (!other_motion_.empty()) {
    problems.reject_file(
        "says above its numbers that they are a " + std::string(other_motion_) + ": " + brief(Json(heads_)),
        "give the file of accelerations");
  }
  times_per_second_ = per_second_in(remarks_, false).value_or(1.0);
  const std::vector<std::string_view> heads = heads_of(heads_);
  const bool are_heads = heads.size() == columns.size();
  const std::string_view spectrum = are_heads ? spectrum_in(heads) : std::string_view();
  if (!spectrum.empty()) {
    problems.reject_file("says above its numbers that they are " + std::string(spectrum) + ": " + brief(Json(heads_)),
                         "give accelerations against time");
  }
  if (are_heads) {
    for (std::size_t i = 0; i < heads.size(); ++i) take_head(heads[i], columns[i], problems);
  }
  check_unit(asked, problems);
}

}  // namespace rocking
