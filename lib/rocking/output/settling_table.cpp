#include "rocking/output/settling_table.hpp"

#include <algorithm>
#include <functional>

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/long_run_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_remedies = 3;

/// Fixed horizons in the limit that is proposed before anything is known of the settling times.
constexpr std::int64_t first_limit_horizons = 20;

std::string whole_text(const std::optional<std::int64_t>& end) { return end ? std::to_string(*end) : "-"; }

std::string share_text(const SettlingRow& row, std::uint64_t count) {
  const std::uint64_t of = row.realisations;
  if (count == 0) {
    return "0 (< " + per_cent(bound_of_none(of, row.confidence)) + " %)";
  }
  return std::to_string(count) + " (" + per_cent_of(count, of) + " %)";
}

/// The value that all rows have; empty if they differ or one has none.
std::string common(std::span<const SettlingRow> rows, std::optional<std::int64_t> SettlingRow::*member) {
  const auto& first = rows.front().*member;
  const bool same = first && std::ranges::all_of(rows, [&](const SettlingRow& row) { return row.*member == first; });
  return same ? std::to_string(*first) : "";
}

/// Periods rounded up to two significant digits.
std::int64_t rounded_up(std::int64_t periods) {
  std::int64_t unit = 1;
  while (periods / unit >= 100) unit *= 10;
  return (periods + unit - 1) / unit * unit;
}

struct SettlingColumn {
  std::string heading;
  std::function<look::Cell(const SettlingRow&)> cell;
};

std::string settling_columns(std::span<const SettlingRow> rows, std::size_t width) {
  const std::string horizon = common(rows, &SettlingRow::fixed_horizon);
  const std::string at = horizon.empty() ? "at the horizon" : "at " + horizon;
  const std::vector<SettlingColumn> columns{
      {"unresolved " + at, [](const SettlingRow& row) { return share_text(row, row.unresolved_at_horizon); }},
      {"in the end", [](const SettlingRow& row) { return share_text(row, row.censored); }},
      {"half settled by", [](const SettlingRow& row) { return period_cell(row.median, row.limit); }},
      {"99 % settled by", [](const SettlingRow& row) { return horizon_text(row.all_but_one_per_cent); }},
      {"differ " + at, [](const SettlingRow& row) { return look::number(row.differ_at_horizon, look::percentage()); }},
      {"differ in the end",
       [](const SettlingRow& row) { return look::number(row.differ_in_the_end, look::percentage()); }}};
  look::Table table = table_of(rows.front().parameters, {});
  for (const SettlingRow& row : rows) table.rows.push_back(row_of(row.parameters));
  for (const SettlingColumn& column : columns) {
    look::Table wider = table;
    add_columns(wider, {column.heading});
    for (std::size_t i = 0; i < rows.size(); ++i) wider.rows[i].push_back(column.cell(rows[i]));
    if (!table.columns.empty() && width_of(wider) > width) break;
    table = std::move(wider);
  }
  return to_terminal(table);
}

/// How often settled responses were left, and of which mode and condition the rate has the highest lower bound.
std::string leaving_line(std::span<const SettlingRow> rows) {
  std::uint64_t left = 0;
  std::uint64_t periods = 0;
  const LeftMode* most = nullptr;
  const SettlingRow* where = nullptr;
  for (const SettlingRow& row : rows) {
    for (const LeftMode& leaving : row.leaving) {
      left += leaving.left;
      periods += leaving.watched_periods;
      if (most != nullptr && leaving.per_1000_periods.low <= most->per_1000_periods.low) continue;
      most = &leaving;
      where = &row;
    }
  }
  if (most == nullptr) return "";
  if (left == 0) return "no settled response was left in " + none_left_text(rows) + '\n';
  const std::string name = values_of(where->parameters);
  return "settled responses were left " + counted(left, "time") + " in " + counted(periods, "watched period") +
         "; most often " + to_string(most->mode) + (name.empty() ? "" : " at " + name) + ": " + leaving_text(*most) +
         " per 1000 periods" + (may_be_left(*most) ? ". A label is that of a window, not of all time" : "") + '\n';
}

LongRunRow long_run_row(const LongRuns& runs) {
  LongRunRow row{.realisations = runs.count, .windows = runs.windows, .shares = {}};
  for (const auto& [mode, found] : runs.shares) {
    row.shares.push_back({.mode = mode, .share = found.share, .interval = found.interval});
  }
  return row;
}

}  // namespace

std::optional<SettlingRow> settling_row(const ReportedCondition& condition) {
  const ConditionResult& result = condition.result;
  if (!result.settling) return std::nullopt;
  const SettlingResult& settling = *result.settling;
  SettlingRow row;
  row.parameters = condition.asked.parameters;
  row.realisations = result.realisations;
  row.confidence = condition.asked.confidence;
  row.censored = settling.censored;
  row.all_but_one_per_cent = settling.times.nearly_all;
  row.differ_at_horizon = settling.differ;
  const auto unresolved = settling.at_horizon.find(section::ResponseMode{});
  if (unresolved != settling.at_horizon.end()) row.unresolved_at_horizon = unresolved->second;
  const Horizon& horizon = condition.asked.horizon;
  if (horizon.until_classified) {
    row.limit = horizon.until_classified->at_most_periods;
    row.held_windows = horizon.until_classified->held_windows;
  }
  if (condition.states_horizon) {
    row.fixed_horizon = std::int64_t{horizon.transient_periods} + horizon.sampled_periods;
    row.confirmation = (std::int64_t{row.held_windows} - 1) * horizon.sampled_periods;
  }
  if (result.non_recurrence) row.differ_in_the_end = result.non_recurrence->differ;
  for (const auto& [mode, leaving] : settling.leaving) {
    row.leaving.push_back({.mode = mode,
                           .left = leaving.left,
                           .watched_periods = leaving.watched_periods,
                           .per_1000_periods = leaving.per_1000_periods});
  }
  if (settling.long_runs) row.long_runs = long_run_row(*settling.long_runs);
  const auto median = std::ranges::find(settling.times.quartiles, 0.5, &stats::QuantileEstimate::level);
  if (median != settling.times.quartiles.end()) row.median = *median;
  return row;
}

std::vector<SettlingRow> settling_rows(const Report& report) {
  std::vector<SettlingRow> rows;
  for (const ReportedCondition& condition : report.conditions) {
    if (auto row = settling_row(condition)) rows.push_back(*std::move(row));
  }
  return rows;
}

look::Cell period_cell(const stats::QuantileEstimate& quantile, const std::optional<std::int64_t>& limit) {
  constexpr int all = 12;  // periods are whole
  look::Number cell{.value = quantile.value, .form = all, .interval = look::Ends(quantile.low, quantile.high)};
  if (quantile.value) return cell;
  if (!limit) return plain_text(cell, "> the limit");
  cell.value = static_cast<double>(*limit);
  cell.bound = '>';
  return cell;
}

std::string horizon_text(const stats::TimeToShare& found) {
  if (!found.time) return found.low ? "> " + std::to_string(*found.low) : "unknown";
  return (found.is_observed ? "" : "about ") + std::to_string(*found.time) + " [" + whole_text(found.low) + ", " +
         whole_text(found.high) + ']';
}

std::string leaving_text(const LeftMode& leaving) {
  const double rate = 1000.0 * static_cast<double>(leaving.left) / static_cast<double>(leaving.watched_periods);
  return significant(rate, 2) + " [" + significant(leaving.per_1000_periods.low, 2) + ", " +
         significant(leaving.per_1000_periods.high, 2) + ']';
}

std::string none_left_text(std::span<const SettlingRow> conditions) {
  std::uint64_t periods = 0;
  double confidence = 0.0;
  for (const SettlingRow& row : conditions) {
    confidence = std::max(confidence, row.confidence);
    for (const LeftMode& leaving : row.leaving) periods += leaving.watched_periods;
  }
  return counted(periods, "watched period") + ": on average fewer than " +
         significant(bound_of_none_left(periods, confidence), 2) +
         " in 1000 periods. A response that is left after the watched windows keeps its label, so that shares of "
         "labels may differ from long-run shares (long_run_every measures them)";
}

std::string end_proviso(std::span<const SettlingRow> conditions) {
  const bool is_needed = std::ranges::any_of(conditions, [](const SettlingRow& row) { return row.held_windows < 2; });
  return is_needed ? "a response is that of the first classified window (held_windows 1) and may be left again later"
                   : "";
}

bool may_be_left(const LeftMode& leaving) { return leaving.left > 0 && leaving.per_1000_periods.high > 1.0; }

std::string limit_remedy(const SettlingRow& condition, const std::string& name) {
  const double share = static_cast<double>(condition.censored) / static_cast<double>(condition.realisations);
  if (share <= ResponseTimes::tolerable_share) return "";
  const stats::TimeToShare& found = condition.all_but_one_per_cent;
  const std::string start = (name.empty() ? "" : name + ": ") + per_cent(share) + " % are not classified" +
                            (condition.limit ? " after " + std::to_string(*condition.limit) + " periods" : "");
  if (found.is_observed) {
    return start +
           ", because their observation ended early; a longer horizon does not help (see the realisations that "
           "the model could not continue)";
  }
  if (!found.time) {
    return start +
           "; none settled in the last half of the observation, so that it cannot be told which horizon would do. "
           "They may never settle";
  }
  return start + ". If they go on settling as in the last half of the observation (" +
         counted(found.events, "response") + "), 1 % are left after about " + std::to_string(rounded_up(*found.time)) +
         " periods [" + whole_text(found.low) + ", " + whole_text(found.high) +
         "]; later if some of them hardly ever settle. Set /horizon/until_classified/at_most_periods to " +
         std::to_string(rounded_up(found.high.value_or(*found.time) + condition.confirmation));
}

std::string settling_text(std::span<const SettlingRow> conditions, std::size_t width) {
  if (conditions.empty()) return "";
  const std::string limit = common(conditions, &SettlingRow::limit);
  std::uint64_t realisations = 0;
  std::uint64_t censored = 0;
  std::vector<std::string> remedies;
  for (const SettlingRow& row : conditions) {
    realisations += row.realisations;
    censored += row.censored;
    if (std::string remedy = limit_remedy(row, values_of(row.parameters)); !remedy.empty())
      remedies.push_back(std::move(remedy));
  }
  const std::string proviso = end_proviso(conditions);
  std::string text =
      "shares are those in the end: an unresolved realisation goes on" +
      (limit.empty() ? std::string(" to its limit") : " for up to " + limit + " periods") + "; " +
      std::to_string(censored) + " of " + counted(realisations, "realisation") + " were not classified by then\n" +
      (proviso.empty() ? "" : "in the end: " + proviso + '\n') + '\n' + settling_columns(conditions, width) +
      "\nsettled by: median and 99 % quantile of the settling period [interval; -: open]; differ: per cent of pairs of "
      "runs with different responses\n" +
      leaving_line(conditions) + long_run_text(conditions, width);
  for (std::size_t i = 0; i < std::min(remedies.size(), most_remedies); ++i) {
    text += "horizon too short: " + remedies[i] + '\n';
  }
  if (remedies.size() > most_remedies) {
    text += "horizon too short: " + counted(remedies.size() - most_remedies, "further condition") + '\n';
  }
  return text;
}

std::string unresolved_remedy(const Report& report) {
  double largest = 0.0;
  const ReportedCondition* worst = nullptr;
  for (const ReportedCondition& condition : report.conditions) {
    const Estimate* unresolved = condition.result.estimate_of(section::ResponseMode{});
    if (!condition.result.is_random() || condition.result.settling || unresolved == nullptr) continue;
    // More periods are no help to those that ended before their horizon.
    const std::uint64_t count = unresolved->counts.successes - condition.result.without_answer();
    const double share = static_cast<double>(count) / static_cast<double>(condition.result.realisations);
    if (share <= largest) continue;
    largest = share;
    worst = &condition;
  }
  if (largest <= worrying_unresolved_share || !worst->states_horizon || !is_periodic(worst->asked.scene.excitation)) {
    return "";
  }
  const Horizon& horizon = worst->asked.horizon;
  const std::int64_t limit = rounded_up(first_limit_horizons * (horizon.transient_periods + horizon.sampled_periods));
  return "add \"until_classified\": {\"at_most_periods\": " + std::to_string(limit) +
         "} to /horizon: unresolved realisations then go on until they are classified, and the report tells which "
         "horizon would do";
}

}  // namespace rocking
