#include "rocking/output/mode_table.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_look.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::Media;
using section::ResponseMode;

constexpr std::size_t gap = 2;
constexpr std::string_view others_heading = "others";
constexpr std::size_t mark_width = 2;
constexpr std::size_t shortest_bar = 12;
constexpr std::size_t longest_bar = 24;
constexpr std::size_t modes_beside_a_bar = 3;

look::Cell cell_of(const ReportedCondition& condition, const ResponseMode& mode) {
  return share_cell(share_of(condition, mode), condition.result.realisations);
}

std::uint64_t others_in(const ReportedCondition& condition, const std::vector<ResponseMode>& shown) {
  std::uint64_t others = condition.result.realisations;
  for (const ResponseMode& mode : shown) others -= count_of(condition, mode);
  return others;
}

std::string bar_of(const ReportedCondition& condition, const std::vector<ResponseMode>& shown, const BarLook& look) {
  std::vector<std::uint64_t> counts;
  for (const ResponseMode& mode : shown) counts.push_back(count_of(condition, mode));
  counts.resize(most_marks, 0);
  counts.back() = others_in(condition, shown);
  return share_bar(counts, look);
}

ConditionColumn others_column(const std::vector<ResponseMode>& shown, const std::string& mark = {}) {
  return {{.title = mark + std::string(others_heading)}, [shown](const ReportedCondition& each) {
            return part_cell(others_in(each, shown), each.result.realisations);
          }};
}

/// What tells the conditions apart; the other forms of the shaking if the lines stay within `width`.
ConditionColumns leading_columns(const Report& report, std::size_t width, Media n) {
  ConditionColumns columns = condition_columns(report, Media::readers, n);
  std::size_t needed = 0;
  for (const auto& [column, cell] : columns) {
    if (is_shown_in(Media::terminal, column.media) && column.title != "n") needed += column.title.size() + gap;
  }
  return needed <= width ? columns : condition_columns(report, Media::publications, n);
}

look::Table run_table_of(const Report& report, const ConditionColumns& columns) {
  look::Table table = part_in(Media::terminal, table_of(report, columns));
  const std::string common = common_shaking(report.swept, shakings_of(report));
  if (!common.empty()) table.notes = "shaking: " + common + '\n';
  return table;
}

/// The modes that occur, those that a table must have first: overturning; the most frequent mode of each condition; then
/// the others, as often as they occur.
struct ModeWidths {
  std::vector<ResponseMode> modes;
  std::size_t indispensable = 0;      ///< so many of them
  std::vector<std::size_t> narrow{};  ///< widths without intervals, with the gap before them
  std::size_t wide = 0;               ///< largest width with an interval, likewise
  std::size_t others = 0;             ///< of all modes without a column of their own, likewise
};

ModeWidths mode_widths(const Report& report) {
  const ModeTally occurring = report.occurring();
  ModeWidths widths{.modes = {}, .others = others_heading.size()};
  for (const auto& [mode, count] : occurring) widths.modes.push_back(mode);
  const auto is_indispensable = [&report](const ResponseMode& mode) {
    return mode.kind == section::ResponseKind::overturned ||
           std::ranges::any_of(report.conditions, [&](const auto& each) {
             return most_frequent_in(each) == mode && count_of(each, mode) > 0;
           });
  };
  const auto importance = [&](const ResponseMode& mode) {
    return std::tuple(mode.kind == section::ResponseKind::overturned, is_indispensable(mode), occurring.at(mode));
  };
  std::ranges::stable_sort(widths.modes, std::ranges::greater(), importance);
  widths.indispensable = static_cast<std::size_t>(std::ranges::count_if(widths.modes, is_indispensable));
  for (const ResponseMode& mode : widths.modes) {
    std::size_t narrow = to_string(mode).size();
    widths.wide = std::max(widths.wide, narrow + mark_width);
    for (const ReportedCondition& condition : report.conditions) {
      const look::Cell cell = cell_of(condition, mode);
      narrow = std::max(narrow, plain_text(without_interval(cell)).size());
      widths.wide = std::max(widths.wide, plain_text(cell).size());
    }
    widths.narrow.push_back(narrow + gap);
  }
  const std::uint64_t most = report.most_realisations();
  widths.others = std::max(widths.others, count_if_open(most, most).size() + 5) + gap;
  widths.wide += gap;
  return widths;
}

/// How many columns fit, of which the first `wide` have intervals.
std::size_t columns_that_fit(const ModeWidths& columns, std::size_t wide, std::size_t room) {
  const auto width_of_first = [&](std::size_t count) {
    std::size_t width = count < columns.modes.size() ? columns.others : 0;
    for (std::size_t i = 0; i < count; ++i) width += i < wide ? columns.wide : columns.narrow[i];
    return width;
  };
  std::size_t count = columns.modes.size();
  while (count > 0 && width_of_first(count) > room) --count;
  return count;
}

/// `friction 0.4/0.35, amplitude 6`, or `the only condition`.
std::string name_of(const ReportedCondition& condition) {
  const std::string name = values_of(condition.asked.parameters);
  return name.empty() ? "the only condition" : name;
}

/// Number of columns of modes, of which the first have intervals, and length of a bar in letters, 0 for no bar.
struct Layout {
  std::size_t modes = 1;
  std::size_t wide = 1;
  std::size_t bar = 0;
};

/// `leading`: the width of the columns before the modes.
Layout layout_of(std::size_t leading, const ModeWidths& columns, const TableLook& look) {
  const std::size_t all = look.width - std::min(look.width, leading);
  const std::size_t room = all - std::min(all, columns.others);
  const std::size_t occurring = columns.modes.size();
  constexpr std::size_t beside_bar = mark_width + gap;
  if (look.bars && occurring > 1 && room >= beside_bar + shortest_bar) {
    const std::size_t fitting = (room - beside_bar - shortest_bar) / columns.wide;
    const std::size_t modes = std::min({fitting, occurring, most_marks - 1});
    if (modes >= std::min(occurring, std::max(modes_beside_a_bar, columns.indispensable))) {
      const std::size_t bar = room - beside_bar - modes * columns.wide;
      return {.modes = modes, .wide = modes, .bar = std::min(longest_bar, bar)};
    }
  }
  std::size_t wide = room / columns.wide;
  if (wide >= columns.indispensable) return {.modes = wide, .wide = wide};
  while (wide > 0 && columns_that_fit(columns, wide, all) < columns.indispensable) --wide;
  return {.modes = std::max<std::size_t>(1, columns_that_fit(columns, wide, all)), .wide = wide};
}

/// Adds the column of a peak if every condition has it and there is room.
void add_peak(const Report& report, std::string_view heading,
              const std::vector<stats::QuantileEstimate>* (*peak)(const PeakQuantiles&), std::size_t width,
              look::Table& table) {
  look::Table wider = table;
  add_columns(wider, {std::string(heading)});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto* quantiles = peak(report.conditions[i].result.peaks);
    if (quantiles == nullptr || quantiles->empty()) return;
    wider.rows[i].emplace_back(peak_cell(*quantiles));
  }
  if (width_of(wider) <= width) table = std::move(wider);
}

void add_peaks(const Report& report, std::size_t width, look::Table& table) {
  using Levels = std::vector<stats::QuantileEstimate>;
  const auto slides = [](const auto& each) { return count_of(each, {.kind = section::ResponseKind::slide}) > 0; };
  add_peak(
      report, peak_tilt_heading, [](const PeakQuantiles& peaks) -> const Levels* { return &peaks.tilt.levels; }, width,
      table);
  if (std::ranges::none_of(report.conditions, slides)) return;
  add_peak(
      report, peak_slip_heading,
      [](const PeakQuantiles& peaks) -> const Levels* { return peaks.slip ? &peaks.slip->metres : nullptr; }, width,
      table);
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

stats::QuantileEstimate quantile_at(const std::vector<stats::QuantileEstimate>& levels, double level) {
  const auto found = std::ranges::find(levels, level, &stats::QuantileEstimate::level);
  return found == levels.end() ? stats::QuantileEstimate{} : *found;
}

std::string peak_cell(const std::vector<stats::QuantileEstimate>& quantiles) {
  const auto in_words = [&quantiles](double level) {
    const auto value = quantile_at(quantiles, level).value;
    return value ? significant(*value, 2) : "-";
  };
  return in_words(0.5) + ' ' + in_words(0.95);
}

std::vector<ResponseMode> modes_to_show(const ModeTally& tally, std::size_t most) {
  ModeTally weighted = tally;
  const auto found = weighted.find({.kind = section::ResponseKind::overturned});
  if (found != weighted.end() && found->second > 0) found->second = std::numeric_limits<std::uint64_t>::max();
  return most_frequent(weighted, most);
}

std::uint64_t count_of(const ReportedCondition& condition, const ResponseMode& mode) {
  const Estimate* found = condition.result.estimate_of(mode);
  return found == nullptr ? 0 : found->counts.successes;
}

ResponseMode most_frequent_in(const ReportedCondition& condition) {
  const auto count = [](const ModeEstimate& each) { return each.probability.counts.successes; };
  const auto most = std::ranges::max_element(condition.result.modes, {}, count);
  return most == condition.result.modes.end() ? ResponseMode{} : most->mode;
}

ConditionColumns mode_columns(const Report& report, std::size_t most) {
  if (!report.is_random()) {
    return {{{.title = "response"}, [](const ReportedCondition& each) -> look::Cell {
               const ResponseMode mode = most_frequent_in(each);
               return count_of(each, mode) > 0 ? look::Cell(to_string(mode)) : look::Cell();
             }}};
  }
  const std::vector<ResponseMode> shown = modes_to_show(report.occurring(), most);
  ConditionColumns columns;
  for (const ResponseMode& mode : shown) {
    columns.push_back({{.title = to_string(mode)}, [mode](const auto& each) { return cell_of(each, mode); }});
  }
  if (report.occurring().size() > shown.size()) columns.push_back(others_column(shown));
  return columns;
}

std::string response_line(const Report& report) {
  const ReportedCondition& only = report.conditions.front();
  const section::ResponseMode mode = most_frequent_in(only);
  const AnyShare share = share_of(only, mode);
  if (report.conditions.size() > 1) return "";
  const std::string name = mode.kind == section::ResponseKind::periodic ? ' ' + to_string(mode) : "";
  const std::string response = "the block " + meaning_of(mode) + name;
  if (!share.interval) return response + '\n';
  return "most likely " + response + ": " + per_cent(share.estimate) + ' ' + per_cent(*share.interval) + " %, " +
         std::to_string(share.count) + " of " + std::to_string(only.result.realisations) + '\n';
}

std::string overturning_line(const Report& report) {
  const auto share = [](const ReportedCondition& each) {
    return share_of(each, ResponseMode{.kind = section::ResponseKind::overturned});
  };
  const ReportedCondition& where =
      *std::ranges::max_element(report.conditions, {}, [&share](const auto& each) { return share(each).estimate; });
  const AnyShare most = share(where);
  const bool is_one = report.conditions.size() == 1;
  if (most.count == 0) {
    std::uint64_t without_answer = 0;
    double bound = 0.0;
    for (const ReportedCondition& each : report.conditions) {
      without_answer += each.result.without_answer();
      if (const auto& interval = share(each).interval) bound = std::max(bound, interval->high);
    }
    return "overturning: none in " + counted(realisations_of(report), "realisation") +
           (without_answer > 0 ? ", of which " + std::to_string(without_answer) + " ended without an answer" : "") +
           (bound > 0.0 ? "; at most " + per_cent(bound) + (is_one ? " %" : " % in each condition") : "") + '\n';
  }
  const auto in_numbers = [&] {
    return per_cent(most.estimate) + ' ' + per_cent(*most.interval) + " %, " + std::to_string(most.count) + " of " +
           std::to_string(where.result.realisations) + '\n';
  };
  if (is_one) return "overturning: " + (most.interval ? in_numbers() : "the block overturns\n");
  const auto overturning =
      std::ranges::count_if(report.conditions, [&share](const auto& each) { return share(each).count > 0; });
  const auto equal =
      std::ranges::count_if(report.conditions, [&](const auto& each) { return share(each).estimate == most.estimate; });
  const std::string among =
      "in " + std::to_string(overturning) + " of " + counted(report.conditions.size(), "condition") + "; ";
  if (!most.interval) return "overturning: " + among + "first at " + name_of(where) + '\n';
  const std::string place = equal == 1 ? "at " : "in " + std::to_string(equal) + " conditions, first at ";
  return "overturning: " + among + "most likely " + place + name_of(where) + ": " + in_numbers();
}

std::string mode_table(const Report& report, const TableLook& look) {
  const auto room_beside = [&look](std::size_t width) { return look.width - std::min(look.width, width + gap); };
  if (!report.is_random()) {
    const ConditionColumns response = mode_columns(report, 1);
    ConditionColumns columns = leading_columns(report, room_beside(response.front().column.title.size()), Media::csv);
    columns.push_back(response.front());
    return to_terminal(run_table_of(report, columns));
  }
  const ModeWidths widths = mode_widths(report);
  ConditionColumns columns = leading_columns(report, room_beside(widths.wide + widths.others), Media::all);
  const Layout layout = layout_of(width_of(table_of(report, columns)), widths, look);
  const auto first = [&widths](std::size_t count) {
    std::vector<ResponseMode> modes = widths.modes;
    modes.resize(std::min(count, modes.size()));
    std::ranges::sort(modes);
    return modes;
  };
  const std::vector<ResponseMode> shown = first(layout.modes), wide = first(layout.wide);
  const auto mark = [&](std::size_t place) { return layout.bar == 0 ? "" : mark_of(place, *look.bars) + ' '; };
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool is_wide = std::ranges::binary_search(wide, shown[i]);
    columns.push_back({{.title = mark(i) + to_string(shown[i])}, [mode = shown[i], is_wide](const auto& each) {
                         return is_wide ? cell_of(each, mode) : without_interval(cell_of(each, mode));
                       }});
  }
  if (shown.size() < widths.modes.size()) columns.push_back(others_column(shown, mark(most_marks - 1)));
  if (layout.bar > 0) {
    columns.push_back({{.title = "shares"}, [&](const ReportedCondition& each) {
                         return bar_of(each, shown, {.length = layout.bar, .letters = *look.bars});
                       }});
  }
  look::Table table = run_table_of(report, columns);
  if (wide.size() < shown.size()) table.notes += "where there is no room for an interval: report.json has it\n";
  add_peaks(report, look.width, table);
  return to_terminal(table);
}

}  // namespace rocking
