#include "analysis/run_figures.hpp"

#include <algorithm>
#include <map>

#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"

namespace rocking::analysis {
namespace {

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
                          {"pairs", "number of pairs"}},
              .rows = {}};
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

std::optional<Figure> divergence_times(const Report& report, const Store& store) {
  const std::vector<Pairs> all = pairs_of(report, store);
  if (std::ranges::all_of(all, [](const Pairs& pairs) { return pairs.diverged.empty(); })) return std::nullopt;
  Figure figure;
  figure.name = "divergence_times";
  figure.title = "Share of diverged pairs of equal runs against time";
  figure.subtitle = report.title();
  Panel panel{.title = "",
              .x = {.quantity = "time", .symbol = "", .unit = "excitation periods", .low = 1.0, .logarithmic = true},
              .y = {.quantity = "share of pairs that have diverged", .symbol = "", .unit = "", .low = 0.0, .high = 1.0},
              .layers = {}};
  panel.x.high = std::max(last_period(report, all), 2.0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = name_of_condition(report, report.conditions[all[i].condition]);
    figure.tables.push_back(table_of(all[i], name.empty() ? "the only condition" : name, *panel.x.high));
    panel.layers.push_back({.kind = LayerKind::steps,
                            .table = i,
                            .columns = {0, 1},
                            .style = style_of_curve(i),
                            .legend = figure.tables.back().name});
  }
  figure.panels.push_back(std::move(panel));
  figure.caption =
      "Share of pairs of runs, with independent random numbers, that have diverged (are more than 0.01 apart in (Θ, "
      "Θ′) at a strobe "
      "instant), against time.";
  if (report.conditions.size() > most_curves)
    figure.caption += " Shown are the seven conditions in which two runs differ most often in response mode.";
  return figure;
}

}  // namespace rocking::analysis
