#include "rocking/output/settling_table.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::Media;

constexpr std::size_t most_remedies = 3;

/// Fixed horizons in the limit that is proposed before anything is known of the settling times.
constexpr std::int64_t first_limit_horizons = 20;

std::string whole_text(const std::optional<std::int64_t>& end) { return end ? std::to_string(*end) : "-"; }

bool has_settling(const ReportedCondition& condition) { return condition.result.settling.has_value(); }

/// The value that all conditions have; empty if they differ or one has none.
std::string common(const Report& report, std::optional<std::int64_t> (*of)(const ReportedCondition&)) {
  std::optional<std::int64_t> found;
  for (const ReportedCondition& each : report.conditions) {
    if (!has_settling(each)) continue;
    const auto number = of(each);
    if (!number || (found && number != found)) return "";
    found = number;
  }
  return found ? std::to_string(*found) : "";
}

/// Periods rounded up to two significant digits.
std::int64_t rounded_up(std::int64_t periods) {
  std::int64_t unit = 1;
  while (periods / unit >= 100) unit *= 10;
  return (periods + unit - 1) / unit * unit;
}

look::Cell share_cell_of(std::uint64_t count, const ReportedCondition& condition) {
  const std::uint64_t all = condition.result.realisations;
  return count > 0 ? part_cell(count, all) : bound_cell(bound_of_none(all, condition.asked.confidence));
}

constexpr int all_digits = 12;  // of periods, which are whole

look::Number number_of(const stats::QuantileEstimate& found) {
  return {.value = found.value, .form = all_digits, .interval = look::Ends(found.low, found.high)};
}

look::Number number_of(const stats::TimeToShare& found) {
  const auto real = [](const auto& end) { return end ? std::optional(static_cast<double>(*end)) : std::nullopt; };
  return {
      .value = real(found.time), .form = look::decimals(0), .interval = look::Ends(real(found.low), real(found.high))};
}

look::Cell differ_cell(const std::optional<double>& differ, const std::optional<stats::Interval>& interval) {
  return differ ? look::number(*differ, interval, look::percentage()) : look::Cell();
}

/// `0.31 [0.01, 1.72]`, left per 1000 watched periods.
look::Cell rate_of(const Leaving& found) {
  return look::number(1000.0 * static_cast<double>(found.left) / static_cast<double>(found.watched_periods),
                      found.per_1000_periods, 2);
}

/// Of all conditions.
struct Watched {
  std::uint64_t left = 0;
  std::uint64_t periods = 0;
  double confidence = 0.0;
  const Leaving* most = nullptr;  ///< with the highest lower bound of the rate
  std::string name = {};          ///< of its mode and condition
};

const SettlingResult& settling_of(const ReportedCondition& condition) { return *condition.result.settling; }
stats::QuantileEstimate median_of(const ReportedCondition& each) {
  return quantile_at(settling_of(each).times.quartiles, 0.5);
}

look::Cell differ_at_horizon(const ReportedCondition& each) {
  return differ_cell(settling_of(each).differ, settling_of(each).differ_interval);
}
look::Cell differ_in_the_end(const ReportedCondition& each) {
  const auto& found = each.result.non_recurrence;
  return found ? differ_cell(found->differ, found->differ_interval) : look::Cell();
}

/// For CSV.
const ConditionColumns& exact_columns() {
  const auto column = [](const char* title) {
    return look::Column{.title = title, .has_interval = true, .media = Media::csv};
  };
  const auto quartile = [](double level) {
    return [level](const ReportedCondition& each) {
      return number_of(quantile_at(settling_of(each).times.quartiles, level));
    };
  };
  static const ConditionColumns columns{
      {{.title = "unresolved_at_horizon", .media = Media::csv},
       [](const ReportedCondition& each) { return look::whole(unresolved_at_horizon(each)); }},
      {{.title = "not_classified", .media = Media::csv},
       [](const ReportedCondition& each) { return look::whole(settling_of(each).censored); }},
      {column("lower_quartile"), quartile(0.25)},
      {column("median"), quartile(0.5)},
      {column("upper_quartile"), quartile(0.75)},
      {column("99_percent"),
       [](const ReportedCondition& each) { return number_of(settling_of(each).times.nearly_all); }},
      {{.title = "99_percent_basis", .media = Media::csv},
       [](const ReportedCondition& each) {
         const stats::TimeToShare& found = settling_of(each).times.nearly_all;
         return found.is_observed ? "observed" : found.time ? "extrapolated" : "unknown";
       }},
      {column("differ_at_horizon"), differ_at_horizon},
      {column("differ"), differ_in_the_end}};
  return columns;
}

/// For readers; a terminal has no room for intervals of the difference.
ConditionColumns columns_in_words(const Report& report) {
  const std::string horizon = common(report, fixed_horizon);
  const std::string at = horizon.empty() ? "at the horizon" : "at " + horizon;
  const auto column = [](const std::string& title, Media media = Media::readers) {
    return look::Column{.title = title, .media = media};
  };
  const auto alone = [](auto cell) {
    return [cell](const ReportedCondition& each) { return without_interval(cell(each)); };
  };
  return {{column("unresolved " + at),
           [](const ReportedCondition& each) { return share_cell_of(unresolved_at_horizon(each), each); }},
          {column("in the end"),
           [](const ReportedCondition& each) { return share_cell_of(settling_of(each).censored, each); }},
          {column("half settled by"),
           [](const ReportedCondition& each) { return period_cell(median_of(each), limit_of(each)); }},
          {column("99 % settled by"),
           [](const ReportedCondition& each) { return horizon_text(settling_of(each).times.nearly_all); }},
          {column("differ " + at, Media::publications), differ_at_horizon},
          {column("differ in the end", Media::publications), differ_in_the_end},
          {column("differ " + at, Media::terminal), alone(differ_at_horizon)},
          {column("differ in the end", Media::terminal), alone(differ_in_the_end)},
          {column("half diverged by", Media::page), [](const ReportedCondition& each) -> look::Cell {
             const auto& quartiles = settling_of(each).times.divergence_quartiles;
             if (quartiles.empty()) return {};
             return period_cell(quantile_at(quartiles, 0.5), fixed_horizon(each));
           }}};
}

std::string settling_legend(const Report& report) {
  return "unresolved, in the end: per cent of the realisations that were not classified at the fixed horizon and in "
         "the end; settled by: median and 99 % quantile of the settling period; differ: per cent of pairs of runs with "
         "different responses [" +
         report.level() +
         " interval]; < x: did not occur, x is the upper end of its interval; > x: beyond the observation" +
         count_legend(report.most_realisations());
}

}  // namespace

std::uint64_t unresolved_at_horizon(const ReportedCondition& condition) {
  const ModeTally& modes = condition.result.settling.value().at_horizon;
  const auto found = modes.find(section::ResponseMode{});
  return found == modes.end() ? 0 : found->second;
}

std::optional<std::int64_t> fixed_horizon(const ReportedCondition& condition) {
  const Horizon& horizon = condition.asked.horizon;
  if (!condition.states_horizon) return std::nullopt;
  return horizon.periods();
}

std::optional<std::int64_t> limit_of(const ReportedCondition& condition) {
  const auto& until = condition.asked.horizon.until_classified;
  return until ? std::optional<std::int64_t>(until->at_most_periods) : std::nullopt;
}

std::string common_limit(const Report& report) { return common(report, limit_of); }

RunTable settling_table(const Report& report) {
  const std::string proviso = end_proviso(report);
  ConditionColumns columns = condition_columns(report, Media::publications, Media::csv | Media::publications);
  for (const ConditionColumns& more : {exact_columns(), columns_in_words(report)}) {
    columns.insert(columns.end(), more.begin(), more.end());
  }
  return {.name = "settling",
          .caption =
              "When responses settled: " + settling_legend(report) + (proviso.empty() ? "" : ". In the end " + proviso),
          .table = table_of(report, columns, has_settling)};
}

RunTable leaving_table(const Report& report) {
  ConditionTable table(report, {{.title = "mode"},
                                {.title = "left"},
                                {.title = "watched_periods", .html = "watched periods"},
                                {.title = "per_1000_periods", .html = "per 1000 periods", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    if (!has_settling(condition)) continue;
    for (const auto& [mode, found] : condition.result.settling->leaving) {
      table.add(condition,
                {to_string(mode), look::whole(found.left), look::whole(found.watched_periods), rate_of(found)});
    }
  }
  return {
      .name = "leaving",
      .caption = "How often settled responses were left again, with exact " + report.level() + " intervals of the rate",
      .table = table.table(),
      .media = Media::csv | Media::page};
}

look::Cell period_cell(const stats::QuantileEstimate& quantile, const std::optional<std::int64_t>& limit) {
  look::Number cell = number_of(quantile);
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

std::string leaving_text(const Report& report) {
  Watched all;
  for (const ReportedCondition& condition : report.conditions) {
    if (!has_settling(condition)) continue;
    all.confidence = std::max(all.confidence, condition.asked.confidence);
    for (const auto& [mode, found] : condition.result.settling->leaving) {
      all.left += found.left;
      all.periods += found.watched_periods;
      if (all.most != nullptr && found.per_1000_periods.low <= all.most->per_1000_periods.low) continue;
      all.most = &found;
      all.name = to_string(mode) + (report.swept.empty() ? "" : " at " + values_of(condition.asked.parameters));
    }
  }
  if (all.most == nullptr) return "";
  if (all.left == 0) {
    return "no settled response was left in " + counted(all.periods, "watched period") + ": on average fewer than " +
           significant(bound_of_none_left(all.periods, all.confidence), 2) +
           " in 1000 periods. A response that is left after the watched windows keeps its label, so that shares of "
           "labels may differ from long-run shares (long_run_every measures them)";
  }
  const bool may_be_left = all.most->left > 0 && all.most->per_1000_periods.high > 1.0;
  return "settled responses were left " + counted(all.left, "time") + " in " + counted(all.periods, "watched period") +
         "; most often " + all.name + ": " + plain_text(rate_of(*all.most)) + " per 1000 periods" +
         (may_be_left ? ". A label is that of a window, not of all time" : "");
}

std::string end_proviso(const Report& report) {
  const bool is_needed = std::ranges::any_of(report.conditions, [](const ReportedCondition& each) {
    const auto& until = each.asked.horizon.until_classified;
    return has_settling(each) && (!until || until->held_windows < 2);
  });
  return is_needed ? "a response is that of the first classified window (held_windows 1) and may be left again later"
                   : "";
}

std::string limit_remedy(const ReportedCondition& condition, const std::string& name) {
  if (!has_settling(condition)) return "";
  const SettlingResult& settling = *condition.result.settling;
  const double share = static_cast<double>(settling.censored) / static_cast<double>(condition.result.realisations);
  const auto limit = limit_of(condition);
  if (share <= ResponseTimes::tolerable_share) return "";
  const stats::TimeToShare& found = settling.times.nearly_all;
  const std::string start = (name.empty() ? "" : name + ": ") + per_cent(share) + " % are not classified" +
                            (limit ? " after " + std::to_string(*limit) + " periods" : "");
  if (found.is_observed) {
    return start +
           ", because their observation ended early; a longer horizon does not help (see the realisations that the "
           "model could not continue)";
  }
  if (!found.time) {
    return start +
           "; none settled in the last half of the observation, so that it cannot be told which horizon would do. They "
           "may never settle";
  }
  return start + ". If they go on settling as in the last half of the observation (" +
         counted(found.events, "response") + "), 1 % are left after about " + std::to_string(rounded_up(*found.time)) +
         " periods [" + whole_text(found.low) + ", " + whole_text(found.high) +
         "]; later if some of them hardly ever settle. Set /horizon/until_classified/at_most_periods to " +
         std::to_string(rounded_up(found.high.value_or(*found.time) +
                                   (condition.states_horizon ? confirmation_periods(condition.asked.horizon) : 0)));
}

std::string settling_text(const Report& report, std::size_t width) {
  if (!report.has_settling()) return "";
  const std::string limit = common_limit(report);
  std::uint64_t realisations = 0;
  std::uint64_t censored = 0;
  std::vector<std::string> remedies;
  for (const ReportedCondition& each : report.conditions) {
    if (!has_settling(each)) continue;
    realisations += each.result.realisations;
    censored += each.result.settling->censored;
    if (std::string remedy = limit_remedy(each, values_of(each.asked.parameters)); !remedy.empty())
      remedies.push_back(std::move(remedy));
  }
  const std::string proviso = end_proviso(report);
  const std::string leaving = leaving_text(report);
  std::string text = "shares are those in the end: an unresolved realisation goes on" +
                     (limit.empty() ? std::string(" to its limit") : " for up to " + limit + " periods") + "; " +
                     std::to_string(censored) + " of " + counted(realisations, "realisation") +
                     " were not classified by then\n" + (proviso.empty() ? "" : "in the end: " + proviso + '\n') +
                     '\n' + to_terminal(narrowed(settling_table(report).table, width)) + '\n' +
                     settling_legend(report) + '\n' + leaving + (leaving.empty() ? "" : "\n") +
                     long_run_text(report, width);
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
  const std::int64_t limit = rounded_up(first_limit_horizons * worst->asked.horizon.periods());
  return "add \"until_classified\": {\"at_most_periods\": " + std::to_string(limit) +
         "} to /horizon: unresolved realisations then go on until they are classified, and the report tells which "
         "horizon would do";
}

}  // namespace rocking
