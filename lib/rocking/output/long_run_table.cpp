#include "rocking/output/settling_table.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::Media;
using section::ResponseMode;

constexpr std::size_t most_columns = 6;       // of a terminal
constexpr std::size_t most_in_documents = 5;  // modes

/// What the shares mean beside the response modes in the end.
constexpr const char* long_run_meaning =
    "A response mode in the end is the label of a window; where responses are left again, the long-run shares tell how "
    "much of the time each mode takes";

using Selection = bool (*)(const ReportedCondition&);

const LongRuns* long_runs_of(const ReportedCondition& condition) {
  const auto& settling = condition.result.settling;
  return settling && settling->long_runs ? &*settling->long_runs : nullptr;
}
std::size_t modes_of(const ReportedCondition& condition) {
  const LongRuns* runs = long_runs_of(condition);
  return runs == nullptr ? 0 : runs->shares.size();
}
bool has_long_runs(const ReportedCondition& condition) { return long_runs_of(condition) != nullptr; }
bool has_several_modes(const ReportedCondition& condition) { return modes_of(condition) > 1; }

/// The most frequent modes of the long runs of these conditions, in the order of the modes.
std::vector<ResponseMode> long_run_modes(const Report& report, Selection is_shown, std::size_t most) {
  ModeTally tally;
  for (const ReportedCondition& condition : report.conditions) {
    if (!is_shown(condition)) continue;
    const LongRuns& runs = *long_runs_of(condition);
    const auto all = static_cast<double>(runs.count * runs.windows);
    for (const auto& [mode, found] : runs.shares)
      tally[mode] += static_cast<std::uint64_t>(std::llround(found.share * all));
  }
  return modes_to_show(tally, most);
}

look::Cell share_of_windows(const ReportedCondition& condition, const ResponseMode& mode) {
  const LongRuns& runs = *long_runs_of(condition);
  if (const auto found = runs.shares.find(mode); found != runs.shares.end())
    return look::number(found->second.share, found->second.interval, look::percentage());
  return bound_cell(bound_of_none(runs.count, condition.asked.confidence));
}

double share_of_others(const ReportedCondition& condition, const std::vector<ResponseMode>& shown) {
  double rest = 0.0;
  for (const auto& [mode, found] : long_runs_of(condition)->shares) {
    if (std::ranges::find(shown, mode) == shown.end()) rest += found.share;
  }
  return rest;
}

look::Table long_runs(const Report& report, Selection is_shown, std::size_t most) {
  const std::vector<ResponseMode> shown = long_run_modes(report, is_shown, most);
  ConditionColumns columns = condition_columns(report);
  columns.push_back({{.title = "long runs"}, [](const auto& each) { return look::whole(long_runs_of(each)->count); }});
  columns.push_back({{.title = "windows of each", .media = Media::publications},
                     [](const auto& each) { return look::whole(long_runs_of(each)->windows); }});
  for (const ResponseMode& mode : shown) {
    columns.push_back({{.title = to_string(mode)}, [mode](const auto& each) { return share_of_windows(each, mode); }});
  }
  const auto has_others = [&](const auto& each) { return is_shown(each) && share_of_others(each, shown) > 0.0; };
  if (std::ranges::any_of(report.conditions, has_others)) {
    columns.push_back({{.title = "others"}, [shown](const ReportedCondition& each) {
                         const double rest = share_of_others(each, shown);
                         return rest > 0.0 ? look::number(rest, look::percentage()) : look::Cell();
                       }});
  }
  return table_of(report, columns, is_shown);
}

/// With as many modes as fit, at least one.
look::Table long_runs_within(const Report& report, std::size_t width) {
  std::size_t most = most_columns;
  look::Table table = long_runs(report, has_several_modes, most);
  while (most > 1 && width_of(table) > width) table = long_runs(report, has_several_modes, --most);
  return table;
}

}  // namespace

RunTable long_run_table(const Report& report) {
  return {.name = "long_run_shares",
          .caption =
              "Long-run shares of time: windows of realisations with a long run by response mode, in per cent [" +
              report.level() + " interval, each mode alone]; < x: no window, x is an upper bound. " + long_run_meaning,
          .table = long_runs(report, has_long_runs, most_in_documents),
          .media = Media::publications};
}

RunTable long_run_share_table(const Report& report) {
  ConditionTable table(report, {{"mode"}, {"long_runs"}, {"windows"}, {.title = "share", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    if (!has_long_runs(condition)) continue;
    const LongRuns& runs = *long_runs_of(condition);
    for (const auto& [mode, found] : runs.shares) {
      table.add(condition, {to_string(mode), look::whole(runs.count), look::whole(runs.windows),
                            look::number(found.share, found.interval, look::percentage())});
    }
  }
  return {.name = "long_run_shares", .caption = "", .table = table.table(), .media = Media::csv};
}

std::string long_run_text(const Report& report, std::size_t width) {
  const auto with_one =
      std::ranges::count_if(report.conditions, [](const auto& condition) { return modes_of(condition) == 1; });
  const std::string with_one_text = with_one == 0 ? ""
                                                  : "long runs: in " +
                                                        counted(static_cast<std::uint64_t>(with_one), "condition") +
                                                        " every window has the same mode\n";
  const auto first = std::ranges::find_if(report.conditions, has_several_modes);
  if (first == report.conditions.end()) return with_one_text;
  const std::uint64_t windows = long_runs_of(*first)->windows;
  const bool same = std::ranges::all_of(report.conditions, [windows](const ReportedCondition& each) {
    return !has_several_modes(each) || long_runs_of(each)->windows == windows;
  });
  return "\nlong-run shares of time: per cent of the last " + (same ? std::to_string(windows) + ' ' : "") +
         "windows of each realisation with a long run [interval]; < x: no window, x is an upper bound\n" +
         to_terminal(long_runs_within(report, width)) + with_one_text + long_run_meaning + '\n';
}

}  // namespace rocking
