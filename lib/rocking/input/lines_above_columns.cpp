#include "rocking/input/lines_above_columns.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "rocking/input/header_words.hpp"
#include "rocking/input/record_unit.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// With blanks in place of what joins a name and its unit: `acc_(cm/s2)`, `acc[g]`.
std::string apart(std::string_view line) {
  std::string text(line);
  std::ranges::replace_if(
      text, [](char c) { return std::string_view("()[]{}_:=\"'").find(c) != std::string_view::npos; }, ' ');
  return text;
}

/// The only unit of acceleration among the words of a line; absent if there is none, or several. `g` alone counts where
/// `with_g`: in a remark it is also a constant.
std::optional<RecordUnit> only_unit_in(std::string_view line, bool with_g) {
  std::optional<RecordUnit> only;
  const std::string text = apart(line);
  for (const StatedUnit& found : units_among_words(text)) {
    if (found.unit.kind != UnitKind::acceleration || (!with_g && found.text.size() == 1)) continue;
    if (only && *only != found.unit.acceleration) return std::nullopt;
    only = found.unit.acceleration;
  }
  return only;
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

/// The heads of columns, between the separators of the line.
std::vector<std::string_view> heads_of(std::string_view line) {
  std::vector<std::string_view> heads;
  if (line.find_first_of(",;\t") == std::string_view::npos) {
    split_fields(line, heads);
    return heads;
  }
  for (;;) {
    const std::size_t end = line.find_first_of(",;\t");
    heads.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return heads;
    line.remove_prefix(end + 1);
  }
}

bool has_any_word(std::string_view head, std::span<const std::string_view> words) {
  const std::string text = apart(head);
  return std::ranges::any_of(words, [&text](std::string_view word) { return word_place(text, word).has_value(); });
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

}  // namespace

void LinesAboveColumns::add(std::string_view line, std::string_view text) {
  if (text.find_first_not_of(" \t\r") != std::string_view::npos) {
    heads_ = text;
    other_motion_ = motion_instead(text);
    stated_ = only_unit_in(text, true);
  } else if (const auto unit = only_unit_in(line.substr(std::min(line.find('#'), line.size())), false)) {
    remarked_ = unit;
  }
}

void LinesAboveColumns::check(const std::vector<RecordColumn>& columns, std::optional<RecordUnit> asked,
                              LineProblems& problems) const {
  if (stated_ && asked && *asked != *stated_) {
    problems.reject_file("states the unit " + std::string(name_of(*stated_)) +
                             " above its numbers, but \"units\" is \"" + std::string(name_of(*asked)) + '"',
                         "omit \"units\", or correct the file");
  }
  if (!other_motion_.empty()) {
    problems.reject_file(
        "says above its numbers that they are a " + std::string(other_motion_) + ": " + brief(Json(heads_)),
        "give the file of accelerations");
  }
  if (!stated_ && !asked && remarked_ && *remarked_ != RecordUnit::m_s2) {
    problems.reject_file("has a comment that names the unit " + std::string(name_of(*remarked_)) +
                             ", and comments are not read: without \"units\" its accelerations would be in m/s2",
                         "give \"units\": \"" + std::string(name_of(*remarked_)) + "\", or that in which they are");
  }
  const std::vector<std::string_view> heads = heads_of(heads_);
  if (heads.size() != columns.size()) return;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const auto name = called(heads[i]);
    if (!name || *name == columns[i] || columns[i] == RecordColumn::other) continue;
    problems.reject_file("has the head " + brief(Json(std::string(heads[i]))) + " above column " +
                             std::to_string(i + 1) + ", which \"columns\" calls \"" + std::string(name_of(columns[i])) +
                             '"',
                         "put the names in the order of the file");
  }
}

}  // namespace rocking
