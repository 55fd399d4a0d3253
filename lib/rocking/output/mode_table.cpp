#include "rocking/output/mode_table.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

#include "rocking/look/text_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using section::ResponseMode;

constexpr std::size_t gap = 2;
constexpr std::string_view others_heading = "others";
constexpr std::size_t mark_width = 2;
constexpr std::size_t shortest_bar = 12;
constexpr std::size_t longest_bar = 24;
constexpr std::size_t modes_beside_a_bar = 3;

// The modes that occur anywhere, in their order, with their counts.
ModeTally occurring_modes(std::span<const TableRow> conditions) {
  ModeTally modes;
  for (const TableRow& condition : conditions) {
    for (const TableEntry& entry : condition.modes) {
      if (entry.count > 0) modes[entry.mode] += entry.count;
    }
  }
  return modes;
}

look::Cell cell(const TableRow& condition, const ResponseMode& mode) {
  const auto found = std::ranges::find(condition.modes, mode, &TableEntry::mode);
  if (found == condition.modes.end()) return {};
  return share_cell({.count = found->count, .estimate = found->estimate, .interval = found->interval},
                    condition.realisations);
}

look::Cell without_interval(look::Cell cell) {
  if (auto* number = std::get_if<look::Number>(&cell)) number->interval.reset();
  return cell;
}

std::uint64_t count_of(const TableRow& condition, const ResponseMode& mode) {
  const auto found = std::ranges::find(condition.modes, mode, &TableEntry::mode);
  return found == condition.modes.end() ? 0 : found->count;
}

std::uint64_t others_in(const TableRow& condition, const std::vector<ResponseMode>& shown) {
  std::uint64_t others = condition.realisations;
  for (const ResponseMode& mode : shown) others -= count_of(condition, mode);
  return others;
}

std::string bar_of(const TableRow& condition, const std::vector<ResponseMode>& shown, const BarLook& look) {
  std::vector<std::uint64_t> counts;
  for (const ResponseMode& mode : shown) counts.push_back(count_of(condition, mode));
  counts.resize(most_marks, 0);
  counts.back() = others_in(condition, shown);
  return share_bar(counts, look);
}

std::vector<std::string> swept_in(std::span<const TableRow> conditions) {
  std::vector<std::string> swept;
  for (const Parameter& parameter : conditions.front().parameters) swept.push_back(parameter.pointer);
  return swept;
}

std::vector<std::optional<Shaking>> shakings_of(std::span<const TableRow> conditions) {
  std::vector<std::optional<Shaking>> shakings;
  for (const TableRow& condition : conditions) shakings.push_back(condition.shaking);
  return shakings;
}

/// The shaking that all conditions have in common; empty if there is none.
std::string common_line(std::span<const TableRow> conditions) {
  const std::string common = common_shaking(swept_in(conditions), shakings_of(conditions));
  return common.empty() ? "" : "shaking: " + common + '\n';
}

/// Whether the factor on a ground motion follows from other numbers, and differs between conditions.
bool has_scales(std::span<const TableRow> conditions) {
  const auto is_swept = [](const Parameter& parameter) { return parameter.pointer == "/excitation/scale"; };
  if (std::ranges::any_of(conditions.front().parameters, is_swept)) return false;
  const auto differs = [&](const TableRow& row) { return row.scale != conditions.front().scale; };
  return std::ranges::any_of(conditions, differs);
}

/// The columns of the swept parameters, and of the shaking in its other form if the lines stay within `width`.
look::Table parameter_table(std::span<const TableRow> conditions, std::size_t width) {
  const std::vector<std::string> swept = swept_in(conditions);
  auto beside = shaking_columns(swept, shakings_of(conditions));
  std::size_t needed = 0;
  for (const std::string& pointer : swept) needed += last_key(pointer).size() + gap;
  for (const std::string_view name : beside) needed += name.size() + gap;
  constexpr std::string_view scale_heading = "scale";
  bool shows_scale = has_scales(conditions);
  if (shows_scale) needed += scale_heading.size() + gap;
  if (width < needed) shows_scale = false;
  if (width < needed) beside.clear();
  look::Table table = table_of(conditions.front().parameters, {beside.begin(), beside.end()});
  if (shows_scale) add_columns(table, {std::string(scale_heading)});
  for (const TableRow& condition : conditions) {
    look::Row& row = table.rows.emplace_back(row_of(condition.parameters));
    for (const std::string_view key : beside) row.emplace_back(column_cell(condition.shaking, key));
    if (shows_scale) row.push_back(look::number(condition.scale, 4));
  }
  table.notes = common_line(conditions);
  return table;
}

/// The modes that occur, those that a table must have first: overturning; the most frequent mode of each condition; then
/// the others, as often as they occur.
struct ModeColumns {
  std::vector<ResponseMode> modes;
  std::size_t indispensable = 0;      ///< so many of them
  std::vector<std::size_t> narrow{};  ///< widths without intervals, with the gap before them
  std::size_t wide = 0;               ///< largest width with an interval, likewise
  std::size_t others = 0;             ///< of all modes without a column of their own, likewise
};

std::vector<ResponseMode> leading_modes(std::span<const TableRow> conditions) {
  std::vector<ResponseMode> leading;
  for (const TableRow& condition : conditions) {
    const auto most = std::ranges::max_element(condition.modes, {}, &TableEntry::count);
    if (most != condition.modes.end() && most->count > 0) leading.push_back(most->mode);
  }
  return leading;
}

ModeColumns mode_columns(std::span<const TableRow> conditions) {
  const ModeTally occurring = occurring_modes(conditions);
  const std::vector<ResponseMode> leading = leading_modes(conditions);
  ModeColumns columns{.modes = {}, .others = others_heading.size()};
  for (const auto& [mode, count] : occurring) columns.modes.push_back(mode);
  const auto is_indispensable = [&leading](const ResponseMode& mode) {
    return mode.kind == section::ResponseKind::overturned || std::ranges::find(leading, mode) != leading.end();
  };
  const auto importance = [&](const ResponseMode& mode) {
    return std::tuple(mode.kind == section::ResponseKind::overturned, is_indispensable(mode), occurring.at(mode));
  };
  std::ranges::stable_sort(columns.modes, std::ranges::greater(), importance);
  columns.indispensable = static_cast<std::size_t>(std::ranges::count_if(columns.modes, is_indispensable));
  for (const ResponseMode& mode : columns.modes) {
    std::size_t narrow = to_string(mode).size();
    columns.wide = std::max(columns.wide, narrow + mark_width);
    for (const TableRow& condition : conditions) {
      narrow = std::max(narrow, plain_text(without_interval(cell(condition, mode))).size());
      columns.wide = std::max(columns.wide, plain_text(cell(condition, mode)).size());
    }
    columns.narrow.push_back(narrow + gap);
  }
  for (const TableRow& condition : conditions) {
    columns.others = std::max(columns.others, count_if_open(condition.realisations, condition.realisations).size() + 5);
  }
  columns.wide += gap;
  columns.others += gap;
  return columns;
}

/// How many columns fit, of which the first `wide` have intervals.
std::size_t columns_that_fit(const ModeColumns& columns, std::size_t wide, std::size_t room) {
  const auto width_of_first = [&](std::size_t count) {
    std::size_t width = count < columns.modes.size() ? columns.others : 0;
    for (std::size_t i = 0; i < count; ++i) width += i < wide ? columns.wide : columns.narrow[i];
    return width;
  };
  std::size_t count = columns.modes.size();
  while (count > 0 && width_of_first(count) > room) --count;
  return count;
}

look::Table leading_columns(std::span<const TableRow> conditions, std::size_t width, const ModeColumns& cells) {
  const std::size_t rest = cells.wide + cells.others + gap;
  look::Table table = parameter_table(conditions, width - std::min(width, rest));
  add_columns(table, {"n"});
  for (std::size_t i = 0; i < conditions.size(); ++i) table.rows[i].push_back(look::whole(conditions[i].realisations));
  return table;
}

/// The table of a run in which nothing is random.
look::Table response_table(std::span<const TableRow> conditions, const TableLook& look) {
  const std::string heading = "response";
  look::Table table = parameter_table(conditions, look.width - std::min(look.width, heading.size() + gap));
  add_columns(table, {heading});
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const auto& modes = conditions[i].modes;
    const auto found = std::ranges::find_if(modes, [](const TableEntry& entry) { return entry.count > 0; });
    table.rows[i].push_back(found == modes.end() ? look::Cell() : to_string(found->mode));
  }
  return table;
}

/// `friction 0.4/0.35, amplitude 6`, or `the only condition`.
std::string name_of(const TableRow& condition) {
  const std::string name = values_of(condition.parameters);
  return name.empty() ? "the only condition" : name;
}

/// Number of columns of modes, of which the first have intervals, and length of a bar in letters, 0 for no bar.
struct Layout {
  std::size_t modes = 1;
  std::size_t wide = 1;
  std::size_t bar = 0;
};

Layout layout_without_bar(std::size_t leading, const ModeColumns& columns, std::size_t width) {
  const std::size_t room = width - std::min(width, leading);
  const std::size_t most = room < columns.others ? 0 : (room - columns.others) / columns.wide;
  if (most >= columns.indispensable) return {.modes = most, .wide = most, .bar = 0};
  for (std::size_t wide = most;; --wide) {
    const std::size_t modes = columns_that_fit(columns, wide, room);
    if (modes >= columns.indispensable || wide == 0) return {.modes = std::max<std::size_t>(1, modes), .wide = wide};
  }
}

/// `leading`: the width of the columns before the modes.
Layout layout_of(std::size_t leading, const ModeColumns& columns, const TableLook& look) {
  const std::size_t occurring = columns.modes.size();
  const std::size_t with_bar = leading + columns.others + mark_width + gap + shortest_bar;
  const std::size_t room = with_bar < look.width ? (look.width - with_bar) / columns.wide : 0;
  const std::size_t modes = std::min({std::max<std::size_t>(1, room), occurring, most_marks - 1});
  const std::size_t wanted = std::min(occurring, std::max(modes_beside_a_bar, columns.indispensable));
  if (!look.bars || occurring < 2 || modes < wanted) return layout_without_bar(leading, columns, look.width);
  const std::size_t left = look.width - std::min(look.width, with_bar + modes * columns.wide);
  return {.modes = modes, .wide = modes, .bar = std::min(longest_bar, shortest_bar + left)};
}

/// Adds the column of a peak if the rows have it and there is room.
void add_peak(std::span<const TableRow> conditions, std::string_view heading, std::string TableRow::*peak,
              const TableLook& look, look::Table& table) {
  std::size_t width = heading.size();
  for (const TableRow& condition : conditions) {
    if ((condition.*peak).empty()) return;
    width = std::max(width, (condition.*peak).size());
  }
  if (width_of(table) + gap + width > look.width) return;
  add_columns(table, {std::string(heading)});
  for (std::size_t i = 0; i < conditions.size(); ++i) table.rows[i].emplace_back(conditions[i].*peak);
}

bool slides(const TableRow& condition) { return count_of(condition, {.kind = section::ResponseKind::slide}) > 0; }

}  // namespace

look::Cell part_cell(std::uint64_t count, std::uint64_t all) {
  if (count == 0) return {};
  return look::number(static_cast<double>(count) / static_cast<double>(all), look::percentage(),
                      count_if_open(count, all));
}

look::Cell share_cell(const AnyShare& share, std::uint64_t realisations) {
  if (share.count == 0) return share.interval ? bound_cell(share.interval->high) : look::Cell();
  return look::number(share.estimate, share.interval, look::percentage(), count_if_open(share.count, realisations));
}

look::Cell bound_cell(double share) { return look::Number{.value = share, .form = look::percentage(), .bound = '<'}; }

std::string peak_cell(const std::vector<stats::QuantileEstimate>& quantiles) {
  std::string text;
  for (const double level : {0.5, 0.95}) {
    const auto found = std::ranges::find(quantiles, level, &stats::QuantileEstimate::level);
    const bool is_there = found != quantiles.end() && found->value;
    text += (text.empty() ? "" : " ") + (is_there ? significant(*found->value, 2) : "-");
  }
  return text;
}

std::vector<ResponseMode> modes_to_show(const ModeTally& tally, std::size_t most) {
  ModeTally weighted = tally;
  const auto found = weighted.find({.kind = section::ResponseKind::overturned});
  if (found != weighted.end() && found->second > 0) found->second = std::numeric_limits<std::uint64_t>::max();
  return most_frequent(weighted, most);
}

std::vector<TableRow> table_rows(const Report& report) {
  const auto modes = report.listed();
  std::vector<TableRow> rows;
  for (const ReportedCondition& condition : report.conditions) {
    TableRow row{.parameters = condition.asked.parameters,
                 .realisations = condition.result.realisations,
                 .without_answer = condition.result.without_answer(),
                 .modes = {},
                 .is_random = condition.result.is_random(),
                 .shaking = condition.shaking,
                 .scale = condition.scale};
    const PeakQuantiles& peaks = condition.result.peaks;
    if (!peaks.tilt.levels.empty()) row.peak_tilt = peak_cell(peaks.tilt.levels);
    if (peaks.slip && !peaks.slip->metres.empty()) row.peak_slip = peak_cell(peaks.slip->metres);
    for (const section::ResponseMode& mode : modes) {
      const AnyShare share = share_of(condition, mode);
      row.modes.push_back({.mode = mode, .count = share.count, .estimate = share.estimate, .interval = share.interval});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string overturning_line(std::span<const TableRow> conditions) {
  if (conditions.empty()) return {};
  const TableRow* where = nullptr;
  TableEntry most{.mode = {.kind = section::ResponseKind::overturned}, .count = 0, .estimate = 0.0, .interval = {}};
  std::size_t overturning = 0;
  std::size_t equal = 0;  // conditions with the largest share
  std::uint64_t realisations = 0;
  std::uint64_t without_answer = 0;
  double bound = 0.0;
  for (const TableRow& condition : conditions) {
    realisations += condition.realisations;
    without_answer += condition.without_answer;
    const auto found = std::ranges::find(condition.modes, most.mode, &TableEntry::mode);
    if (found == condition.modes.end()) continue;
    if (found->interval) bound = std::max(bound, found->interval->high);
    if (found->count > 0) ++overturning;
    if (where != nullptr && found->estimate == most.estimate) ++equal;
    if (found->estimate > most.estimate) {
      most = *found;
      where = &condition;
      equal = 1;
    }
  }
  if (where == nullptr) {
    return "overturning: none in " + counted(realisations, "realisation") +
           (without_answer > 0 ? ", of which " + std::to_string(without_answer) + " ended without an answer" : "") +
           (bound > 0.0 ? "; at most " + per_cent(bound) + " % in each condition" : "") + '\n';
  }
  const std::string among =
      "in " + std::to_string(overturning) + " of " + counted(conditions.size(), "condition") + "; ";
  if (!most.interval) return "overturning: " + among + "first at " + name_of(*where) + '\n';
  const std::string place = equal == 1 ? "at " : "in " + std::to_string(equal) + " of them, first at ";
  return "overturning: " + among + "most likely " + place + name_of(*where) + ": " + per_cent(most.estimate) + ' ' +
         per_cent(*most.interval) + " %, " + std::to_string(most.count) + " of " + std::to_string(where->realisations) +
         '\n';
}

std::string mode_table(std::span<const TableRow> conditions, const TableLook& look) {
  if (conditions.empty()) return {};
  if (std::ranges::none_of(conditions, &TableRow::is_random)) return to_terminal(response_table(conditions, look));
  const ModeColumns columns = mode_columns(conditions);
  look::Table table = leading_columns(conditions, look.width, columns);
  const Layout layout = layout_of(width_of(table), columns, look);
  const auto first = [&columns](std::size_t count) {
    std::vector<ResponseMode> modes = columns.modes;
    modes.resize(std::min(count, modes.size()));
    std::ranges::sort(modes);
    return modes;
  };
  const std::vector<ResponseMode> shown = first(layout.modes), wide = first(layout.wide);
  const auto is_wide = [&wide](const ResponseMode& mode) { return std::ranges::binary_search(wide, mode); };
  const bool with_others = shown.size() < columns.modes.size();
  const auto mark = [&](std::size_t place) { return layout.bar == 0 ? "" : mark_of(place, *look.bars) + ' '; };
  for (std::size_t i = 0; i < shown.size(); ++i) add_columns(table, {mark(i) + to_string(shown[i])});
  if (with_others) add_columns(table, {mark(most_marks - 1) + std::string(others_heading)});
  if (layout.bar > 0) add_columns(table, {"shares"});
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const TableRow& condition = conditions[i];
    look::Row& row = table.rows[i];
    for (const ResponseMode& mode : shown) {
      row.push_back(is_wide(mode) ? cell(condition, mode) : without_interval(cell(condition, mode)));
    }
    if (with_others) row.push_back(part_cell(others_in(condition, shown), condition.realisations));
    if (layout.bar > 0) row.emplace_back(bar_of(condition, shown, {.length = layout.bar, .letters = *look.bars}));
  }
  if (wide.size() < shown.size()) table.notes += "where there is no room for an interval: report.json has it\n";
  add_peak(conditions, peak_tilt_heading, &TableRow::peak_tilt, look, table);
  if (std::ranges::any_of(conditions, slides)) {
    add_peak(conditions, peak_slip_heading, &TableRow::peak_slip, look, table);
  }
  return to_terminal(table);
}

}  // namespace rocking
