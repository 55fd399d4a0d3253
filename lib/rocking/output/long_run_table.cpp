#include "rocking/output/long_run_table.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using section::ResponseMode;

constexpr std::size_t most_columns = 6;

look::Table long_run_table(std::span<const SettlingRow> rows, const std::vector<ResponseMode>& shown) {
  look::Table table = table_of(rows.front().parameters, {"long runs"});
  for (const ResponseMode& mode : shown) add_columns(table, {to_string(mode)});
  bool has_others = false;
  for (const SettlingRow& each : rows) {
    look::Row& row = table.rows.emplace_back(row_of(each.parameters, {look::whole(each.long_runs->realisations)}));
    for (const ResponseMode& mode : shown) row.push_back(long_run_cell(each, mode));
    row.push_back(other_long_run_shares(each, shown));
    has_others = has_others || !std::holds_alternative<std::monostate>(row.back());
  }
  if (has_others) {
    add_columns(table, {"others"});
  } else {
    for (look::Row& row : table.rows) row.pop_back();
  }
  return table;
}

/// The table with as many modes as fit, at least one.
std::string long_run_columns(std::span<const SettlingRow> rows, std::size_t width) {
  for (std::size_t most = most_columns; most > 1; --most) {
    const look::Table table = long_run_table(rows, long_run_modes(rows, most));
    if (width_of(table) <= width) return to_terminal(table);
  }
  return to_terminal(long_run_table(rows, long_run_modes(rows, 1)));
}

}  // namespace

std::vector<ResponseMode> long_run_modes(std::span<const SettlingRow> conditions, std::size_t most) {
  ModeTally tally;
  for (const SettlingRow& row : conditions) {
    if (!row.long_runs) continue;
    const auto all = static_cast<double>(row.long_runs->realisations * row.long_runs->windows);
    for (const LongRunShare& found : row.long_runs->shares) {
      tally[found.mode] += static_cast<std::uint64_t>(std::llround(found.share * all));
    }
  }
  return modes_to_show(tally, most);
}

look::Cell long_run_cell(const SettlingRow& condition, const ResponseMode& mode) {
  const auto& shares = condition.long_runs->shares;
  const auto found = std::ranges::find(shares, mode, &LongRunShare::mode);
  if (found != shares.end()) return look::number(found->share, found->interval, look::percentage());
  return bound_cell(bound_of_none(condition.long_runs->realisations, condition.confidence));
}

look::Cell other_long_run_shares(const SettlingRow& condition, std::span<const ResponseMode> shown) {
  double rest = 0.0;
  for (const LongRunShare& found : condition.long_runs->shares) {
    if (std::ranges::find(shown, found.mode) == shown.end()) rest += found.share;
  }
  return rest > 0.0 ? look::number(rest, look::percentage()) : look::Cell();
}

std::string long_run_text(std::span<const SettlingRow> conditions, std::size_t width) {
  std::vector<SettlingRow> several;
  std::size_t with_one = 0;
  for (const SettlingRow& row : conditions) {
    if (!row.long_runs || row.long_runs->shares.empty()) continue;
    if (row.long_runs->shares.size() > 1) {
      several.push_back(row);
    } else {
      ++with_one;
    }
  }
  if (several.empty() && with_one == 0) return "";
  const std::string with_one_text =
      with_one == 0 ? "" : "long runs: in " + counted(with_one, "condition") + " every window has the same mode\n";
  if (several.empty()) return with_one_text;
  const std::uint64_t windows = several.front().long_runs->windows;
  const bool same =
      std::ranges::all_of(several, [windows](const SettlingRow& row) { return row.long_runs->windows == windows; });
  return "\nlong-run shares of time: per cent of the last " + (same ? std::to_string(windows) + ' ' : "") +
         "windows of each realisation with a long run [interval]; < x: no window, x is an upper bound\n" +
         long_run_columns(several, width) + with_one_text + long_run_meaning + '\n';
}

}  // namespace rocking
