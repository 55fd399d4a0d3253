#include <algorithm>
#include <array>
#include <map>

#include "analysis/figure_scripts.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"

namespace rocking::analysis {
namespace {

bool has_differences(const Report& report) {
  return std::any_of(report.conditions.begin(), report.conditions.end(),
                     [](const ReportedCondition& condition) { return condition.result.non_recurrence.has_value(); });
}

Table difference_table(const Report& report, const SweepView& view, const Slice& slice) {
  const std::string level = report.level() + " interval";
  Table table{.name = slice.words(),
              .columns = {view.column,
                          {"n", "realisations"},
                          {"differ", "probability that two runs differ in response mode", level},
                          {"low", "lower end of its " + level},
                          {"high", "upper end of its " + level},
                          {"entropy", "entropy of the response modes [nat]"}}};
  for (const std::size_t i : slice.conditions) {
    const ReportedCondition& condition = report.conditions[i];
    if (!condition.result.non_recurrence) continue;
    const NonRecurrence& found = *condition.result.non_recurrence;
    table.rows.push_back({view.x[i], condition.result.realisations, found.differ, found.differ_interval.low,
                          found.differ_interval.high, found.entropy});
  }
  return table;
}

Table divergence_table(const Report& report, const SweepView& view, const Slice& slice) {
  Table table{.name = slice.words(),
              .columns = {view.column,
                          {"pairs", "pairs of runs"},
                          {"diverged", "of these diverged before the horizon"},
                          {"median", "median of the divergence time [periods]"},
                          {"lower", "lower quartile [periods]"},
                          {"upper", "upper quartile [periods]"},
                          {"upper_drawn", "upper quartile as drawn, cut at the horizon [periods]"}}};
  const auto periods = report.periods();
  for (const std::size_t i : slice.conditions) {
    if (!report.conditions[i].result.non_recurrence) continue;
    const DivergenceTimes& divergence = report.conditions[i].result.non_recurrence->friction;
    if (divergence.pairs == 0) continue;
    const Cell end = divergence.lower_quartile && periods ? Cell(*periods) : Cell();
    table.rows.push_back({view.x[i], divergence.pairs, divergence.diverged, divergence.median,
                          divergence.lower_quartile, divergence.upper_quartile,
                          divergence.upper_quartile ? Cell(*divergence.upper_quartile) : end});
  }
  return table;
}

/// Adds a ribbon and its curve, or bars of categories, for the table that was added last.
void add_curve(const SweepView& view, std::size_t number, const std::array<std::string, 3>& columns, Figure& figure) {
  const std::string name = view.slices[number].words();
  const Style style = style_of_curve(number);
  if (!view.is_line) {
    const Table whole = figure.tables.back();
    return add_bars(whole, {number, view.slices.size(), columns, style, name}, figure);
  }
  const auto& [value, low, high] = columns;
  const std::size_t table = figure.tables.size() - 1;
  draw({.kind = LayerKind::ribbon, .table = table, .style = ribbon_of(style)}, {view.column.name, low, high}, figure);
  draw({.kind = LayerKind::line, .table = table, .style = style, .legend = name}, {view.column.name, value}, figure);
}

Figure empty_figure(const Report& report, const SweepView& view) {
  Figure figure;
  figure.subtitle = report.title();
  Panel panel{.x = view.axis, .y = {}};
  set_range(view, panel);
  figure.panels.push_back(std::move(panel));
  return figure;
}

constexpr std::size_t most_curves = 7;

/// The pairs (0,1), (2,3), ... of a condition, with their divergence times.
struct Pairs {
  std::size_t condition = 0;
  std::uint64_t count = 0;
  std::map<std::int64_t, std::uint64_t> diverged;  ///< number of pairs that diverged, by period
};

std::vector<Pairs> pairs_of(const Report& report, const Store& store) {
  std::vector<Pairs> all(report.conditions.size());
  store.for_each([&](const RealisationKey& key, const Summary& summary) {
    if (key.condition >= all.size()) return;
    const std::uint64_t whole = report.conditions[key.condition].result.realisations / 2 * 2;
    if (key.realisation % 2 != 0 || key.realisation >= whole) return;
    Pairs& pairs = all[key.condition];
    pairs.condition = key.condition;
    ++pairs.count;
    if (summary.diverged_from_next) ++pairs.diverged[*summary.diverged_from_next];
  });
  std::erase_if(all, [](const Pairs& pairs) { return pairs.count == 0; });
  const auto differ = [&report](const Pairs& pairs) {
    const auto& difference = report.conditions[pairs.condition].result.non_recurrence;
    return difference ? difference->differ : 0.0;
  };
  std::stable_sort(all.begin(), all.end(), [&](const Pairs& a, const Pairs& b) { return differ(a) > differ(b); });
  if (all.size() > most_curves) all.resize(most_curves);
  std::stable_sort(all.begin(), all.end(), [](const Pairs& a, const Pairs& b) { return a.condition < b.condition; });
  return all;
}

/// The horizon; if conditions have different horizons, the period in which the last pair diverged.
double last_period(const Report& report, const std::vector<Pairs>& all) {
  if (const auto periods = report.periods()) return static_cast<double>(*periods);
  std::int64_t last = 0;
  for (const Pairs& pairs : all) {
    if (!pairs.diverged.empty()) last = std::max(last, pairs.diverged.rbegin()->first);
  }
  return static_cast<double>(last);
}

/// A row for each period in which pairs diverged, and for the start and the horizon. Nothing can diverge before the
/// first period.
Table table_of(const Pairs& pairs, const std::string& name, double horizon) {
  Table table{.name = name,
              .columns = {{"period", "excitation periods since the start"},
                          {"share", "share of pairs that have diverged by then"},
                          {"diverged", "pairs that have diverged by then"},
                          {"pairs", "number of pairs"}}};
  const auto count = static_cast<double>(pairs.count);
  double diverged = 0.0;
  const auto add = [&](double period) { table.rows.push_back({period, diverged / count, diverged, count}); };
  if (pairs.diverged.empty() || pairs.diverged.begin()->first > 1) add(1.0);
  for (const auto& [period, number] : pairs.diverged) {
    diverged += static_cast<double>(number);
    add(static_cast<double>(period));
  }
  add(horizon);
  return table;
}

}  // namespace

std::optional<Figure> non_recurrence(const Report& report) {
  if (!has_differences(report)) return std::nullopt;
  const SweepView view = view_of(report);
  Figure figure = empty_figure(report, view);
  figure.name = "non_recurrence";
  figure.title = "Probability that two equal runs have different responses";
  figure.panels.front().y = {.quantity = "probability that two runs differ", .low = 0.0, .high = 1.0};
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(difference_table(report, view, view.slices[i]));
    add_curve(view, i, {"differ", "low", "high"}, figure);
  }
  figure.caption =
      "Probability that two runs of one condition, with independent random numbers, differ in response mode, with "
      "its " +
      report.level() + " interval; " + realisations_in_words(report) + '.' + slices_left_out(view);
  return figure;
}

std::optional<Figure> divergence_quartiles(const Report& report) {
  if (!has_differences(report)) return std::nullopt;
  const SweepView view = view_of(report);
  Figure figure = empty_figure(report, view);
  figure.name = "divergence_quartiles";
  figure.title = "Divergence time of two equal runs";
  figure.panels.front().y = {
      .quantity = "divergence time", .unit = "excitation periods", .low = 1.0, .logarithmic = true};
  bool any = false;
  for (std::size_t i = 0; i < view.slices.size(); ++i) {
    figure.tables.push_back(divergence_table(report, view, view.slices[i]));
    const auto& rows = figure.tables.back().rows;
    any = any ||
          std::any_of(rows.begin(), rows.end(), [](const auto& row) { return std::holds_alternative<double>(row[4]); });
    add_curve(view, i, {"median", "lower", "upper_drawn"}, figure);
  }
  if (!any) return std::nullopt;
  figure.caption =
      "Periods until two runs of one condition, with independent random numbers, are more than 0.01 apart in (Θ, Θ′): "
      "median (markers) and quartiles over pairs (" +
      std::string(view.is_line ? "ribbon" : "bars") + ", cut at the horizon). Where no marker or no " +
      (view.is_line ? "ribbon is" : "bars are") +
      " shown, more than half, or three quarters, of the pairs had not diverged by the horizon." +
      slices_left_out(view);
  return figure;
}

std::optional<Figure> divergence_times(const Report& report, const Store& store) {
  const std::vector<Pairs> all = pairs_of(report, store);
  if (std::ranges::all_of(all, [](const Pairs& pairs) { return pairs.diverged.empty(); })) return std::nullopt;
  Figure figure{.name = "divergence_times",
                .title = "Share of diverged pairs of equal runs against time",
                .subtitle = report.title()};
  Panel panel{.x = {.quantity = "time", .unit = "excitation periods", .low = 1.0, .logarithmic = true},
              .y = {.quantity = "share of pairs that have diverged", .low = 0.0, .high = 1.0}};
  const double end = std::max(last_period(report, all), 2.0);
  panel.x.high = end;
  figure.panels.push_back(std::move(panel));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = name_of_condition(report, report.conditions[all[i].condition]);
    Table table = table_of(all[i], name.empty() ? "the only condition" : name, end);
    const std::string legend = table.name;
    draw(std::move(table), {.kind = LayerKind::steps, .style = style_of_curve(i), .legend = legend}, {}, figure);
  }
  figure.caption =
      "Share of pairs of runs, with independent random numbers, that have diverged (are more than 0.01 apart in (Θ, "
      "Θ′) at a strobe instant), against time.";
  if (report.conditions.size() > most_curves)
    figure.caption += " Shown are the seven conditions in which two runs differ most often in response mode.";
  return figure;
}

}  // namespace rocking::analysis
