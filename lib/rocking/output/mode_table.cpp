#include "rocking/output/mode_table.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

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

/// Largest widths of the columns of a table, with the gap before them.
struct CellWidths {
  std::size_t mode = 0;    ///< of a response mode
  std::size_t others = 0;  ///< of all modes without a column of their own
};

CellWidths cell_widths(std::span<const TableRow> conditions, const ModeTally& occurring) {
  CellWidths widths{.mode = 0, .others = others_heading.size()};
  for (const auto& [mode, count] : occurring) {
    widths.mode = std::max(widths.mode, to_string(mode).size() + mark_width);
    for (const TableRow& condition : conditions)
      widths.mode = std::max(widths.mode, plain_text(cell(condition, mode)).size());
  }
  for (const TableRow& condition : conditions) {
    widths.others = std::max(widths.others, count_if_open(condition.realisations, condition.realisations).size() + 5);
  }
  return {.mode = widths.mode + gap, .others = widths.others + gap};
}

look::Table leading_columns(std::span<const TableRow> conditions, std::size_t width, const CellWidths& cells) {
  const std::size_t rest = cells.mode + cells.others + gap;
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

// Number of columns of modes, and length of a bar in letters, 0 for no bar.
struct Layout {
  std::size_t modes = 1;
  std::size_t bar = 0;
};

Layout layout_of(std::size_t used, std::size_t occurring, std::size_t cell_width, const TableLook& look) {
  const auto room_beside = [&](std::size_t taken) {
    return taken < look.width ? std::max<std::size_t>(1, (look.width - taken) / cell_width) : 1;
  };
  const std::size_t with_bar = used + mark_width + gap + shortest_bar;
  const std::size_t modes = std::min({room_beside(with_bar), occurring, most_marks - 1});
  const bool drawn = look.bars && occurring > 1 && modes >= std::min(occurring, modes_beside_a_bar);
  if (!drawn) return {.modes = room_beside(used), .bar = 0};
  const std::size_t left = look.width - std::min(look.width, with_bar + modes * cell_width);
  return {.modes = modes, .bar = std::min(longest_bar, shortest_bar + left)};
}

/// Adds the column of the peak tilt if there is room.
void add_peak_tilt(std::span<const TableRow> conditions, const TableLook& look, look::Table& table) {
  std::size_t width = peak_tilt_heading.size();
  for (const TableRow& condition : conditions) {
    if (condition.peak_tilt.empty()) return;
    width = std::max(width, condition.peak_tilt.size());
  }
  if (width_of(table) + gap + width > look.width) return;
  add_columns(table, {std::string(peak_tilt_heading)});
  for (std::size_t i = 0; i < conditions.size(); ++i) table.rows[i].emplace_back(conditions[i].peak_tilt);
}

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

std::string peak_tilt_cell(const std::vector<stats::QuantileEstimate>& quantiles) {
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
    const auto& tilts = condition.result.peaks.tilt.levels;
    if (!tilts.empty()) row.peak_tilt = peak_tilt_cell(tilts);
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
  const auto occurring = occurring_modes(conditions);
  const CellWidths widths = cell_widths(conditions, occurring);
  look::Table table = leading_columns(conditions, look.width, widths);
  const Layout layout = layout_of(width_of(table) + widths.others, occurring.size(), widths.mode, look);
  const std::vector<ResponseMode> shown = modes_to_show(occurring, layout.modes);
  const bool with_others = shown.size() < occurring.size();
  const auto mark = [&](std::size_t place) { return layout.bar == 0 ? "" : mark_of(place, *look.bars) + ' '; };
  for (std::size_t i = 0; i < shown.size(); ++i) add_columns(table, {mark(i) + to_string(shown[i])});
  if (with_others) add_columns(table, {mark(most_marks - 1) + std::string(others_heading)});
  if (layout.bar > 0) add_columns(table, {"shares"});
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const TableRow& condition = conditions[i];
    look::Row& row = table.rows[i];
    for (const ResponseMode& mode : shown) row.push_back(cell(condition, mode));
    if (with_others) row.push_back(part_cell(others_in(condition, shown), condition.realisations));
    if (layout.bar > 0) row.emplace_back(bar_of(condition, shown, {.length = layout.bar, .letters = *look.bars}));
  }
  add_peak_tilt(conditions, look, table);
  return to_terminal(table);
}

}  // namespace rocking
