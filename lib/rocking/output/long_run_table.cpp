#include "rocking/output/long_run_table.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using section::ResponseMode;

constexpr std::size_t most_columns = 6;

std::vector<TextRow> long_run_rows(std::span<const SettlingRow> rows, const std::vector<ResponseMode>& shown) {
  std::vector<TextRow> table(rows.size() + 1);
  for (const Parameter& parameter : rows.front().parameters) table[0].push_back(last_key(parameter.pointer));
  table[0].emplace_back("long runs");
  for (const ResponseMode& mode : shown) table[0].push_back(to_string(mode));
  bool has_others = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TextRow& cells = table[i + 1];
    for (const Parameter& parameter : rows[i].parameters) cells.push_back(short_value(parameter));
    cells.push_back(std::to_string(rows[i].long_runs->realisations));
    for (const ResponseMode& mode : shown) cells.push_back(long_run_cell(rows[i], mode));
    cells.push_back(other_long_run_shares(rows[i], shown));
    has_others = has_others || cells.back() != ".";
  }
  table[0].emplace_back("others");
  if (!has_others) {
    for (TextRow& cells : table) cells.pop_back();
  }
  return table;
}

/// The table with as many modes as fit, at least one.
std::string long_run_columns(std::span<const SettlingRow> rows, std::size_t width) {
  for (std::size_t most = most_columns; most > 1; --most) {
    std::string text = aligned(long_run_rows(rows, long_run_modes(rows, most)));
    if (letters_in(text.substr(0, text.find('\n'))) <= width) return text;
  }
  return aligned(long_run_rows(rows, long_run_modes(rows, 1)));
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

std::string long_run_cell(const SettlingRow& condition, const ResponseMode& mode) {
  const auto& shares = condition.long_runs->shares;
  const auto found = std::ranges::find(shares, mode, &LongRunShare::mode);
  if (found != shares.end()) return per_cent(found->share) + ' ' + per_cent(found->interval);
  return "< " + per_cent(bound_of_none(condition.long_runs->realisations, condition.confidence));
}

std::string other_long_run_shares(const SettlingRow& condition, std::span<const ResponseMode> shown) {
  double rest = 0.0;
  for (const LongRunShare& found : condition.long_runs->shares) {
    if (std::ranges::find(shown, found.mode) == shown.end()) rest += found.share;
  }
  return rest > 0.0 ? per_cent(rest) : ".";
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
