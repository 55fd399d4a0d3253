#include "rocking/studies/cost/study.hpp"

#include "rocking/figures/palette.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr double micro = 1e6;
constexpr double hundred = 100.0;

/// A number that can be drawn on a logarithmic axis, or nothing.
Cell positive(const std::optional<double>& number) {
  if (!number || *number <= 0.0) return {};
  return *number;
}

std::string three_digits(double number) { return significant(number, 3); }

std::string own_tolerance_in_words(const CostReport& report) {
  const Json& experiment = report.input.experiment;
  const Json::json_pointer place("/accuracy/tolerance");
  if (!experiment.contains(place) || !experiment[place].is_number()) return "";
  for (const Json& entry : experiment.contains("sweep") ? experiment["sweep"] : Json::array()) {
    const bool is_axis = entry.is_object() && entry.contains("parameter");
    if (is_axis && entry["parameter"] == place.to_string()) return "The experiment sweeps its tolerance.";
  }
  return "The experiment's own tolerance is " + three_digits(experiment[place].get<double>()) + ".";
}

Table tolerance_table(const CostReport& report) {
  Table table{
      .name = "tolerances",
      .columns = {{"tolerance", "tolerance of the steps"},
                  {"median_error", "median over the realisations of the largest error in the first periods"},
                  {"largest_error", "the largest of all realisations"},
                  {"changed", "response modes that differ from those at the tightest tolerance [%]", "exact interval"},
                  {"changed_low", "lower end of its exact interval [%]; absent if all realisations were measured"},
                  {"changed_high", "upper end of its exact interval [%]"},
                  {"time", "processor time per period [us]"},
                  {"name", "the tolerance, as text"}}};
  for (std::size_t i = 0; i < report.cost.curve.size(); ++i) {
    const auto& [tolerance, periods, steps, departure] = report.cost.curve[i];
    Row row{tolerance, {}, {}, {}, {}, {}, micro * report.cost.seconds_per_period(i), three_digits(tolerance)};
    if (departure) {
      row[1] = positive(departure->median_error);
      row[2] = positive(departure->largest_error);
      const stats::Proportion& flips = departure->flips;
      row[3] = hundred * static_cast<double>(flips.successes) / static_cast<double>(flips.trials);
      if (!report.cost.yardstick.is_everything) {
        row[4] = hundred * departure->flips_interval.low;
        row[5] = hundred * departure->flips_interval.high;
      }
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Of the first table.
void add_curve(std::size_t number, const std::string& x, const std::string& y, const std::string& legend,
               Figure& figure) {
  draw({.kind = LayerKind::line, .style = style_of_curve(number), .legend = legend}, {x, y}, figure);
}

void add_title(Figure& figure, const CostReport& report) {
  figure.subtitle = report.input.title();
  figure.caption += " Of " + std::to_string(report.cost.sample) + " realisations of " +
                    std::to_string(report.cost.sampled_conditions) + " conditions; times of one processor.";
}

Axis tolerance_axis() { return {.quantity = "tolerance", .logarithmic = true}; }

Figure cost_tolerance(const CostReport& report) {
  Figure figure{
      .name = "cost_tolerance", .title = "Effect and cost of a tolerance", .arrangement = Arrangement::stacked};
  figure.tables = {tolerance_table(report)};
  const auto add_panel = [&figure](Axis y) { figure.panels.push_back({.x = tolerance_axis(), .y = std::move(y)}); };
  add_panel({.quantity = "error", .logarithmic = true});
  add_curve(0, "tolerance", "median_error", "median", figure);
  add_curve(1, "tolerance", "largest_error", "largest", figure);
  add_panel({.quantity = "changed modes", .unit = "%", .low = 0.0});
  add_curve(0, "tolerance", "changed", "", figure);
  draw({.kind = LayerKind::error_bars, .style = style_of_curve(0)},
       {"tolerance", "changed", "changed_low", "changed_high"}, figure);
  add_panel({.quantity = "time per period", .unit = "µs", .low = 0.0});
  add_curve(0, "tolerance", "time", "", figure);
  figure.caption = "Error: largest difference from the tightest tolerance in Θ, Θ′, V over the first " +
                   std::to_string(cost_error_periods) +
                   " periods. Changed modes with the exact interval of a sample. " + own_tolerance_in_words(report);
  add_title(figure, report);
  return figure;
}

Figure work_precision(const CostReport& report) {
  Figure figure{.name = "work_precision",
                .title = "Cost of accuracy in time",
                .tables = {tolerance_table(report)},
                .panels = {{.x = {.quantity = "error in the first periods", .logarithmic = true},
                            .y = {.quantity = "processor time per period", .unit = "µs", .low = 0.0}}}};
  add_curve(0, "median_error", "time", "median", figure);
  add_curve(1, "largest_error", "time", "largest", figure);
  figure.caption = "One point for each tolerance from " + cell_text(figure.tables[0].rows.front()[7]) + " to " +
                   cell_text(figure.tables[0].rows[figure.tables[0].rows.size() - 2][7]) +
                   "; tighter tolerances are to the left.";
  add_title(figure, report);
  return figure;
}

Table realisations_table(const CostReport& report) {
  Table table{
      .name = "realisations",
      .columns = {{"factor", "factor on the number of realisations of the experiment"},
                  {"periods", "of the whole run"},
                  {"time", "processor time at the experiment's tolerance [s]"},
                  {"mean", "half-width of a condition's widest simultaneous interval, mean over conditions [%]"},
                  {"widest", "the largest over all conditions [%]"},
                  {"wilson", "the largest half-width of Wilson's intervals [%]"}}};
  for (std::size_t i = 0; i < report.cost.planned.size(); ++i) {
    const auto& [factor, widths, periods, seconds] = report.cost.planned[i];
    table.rows.push_back({factor, periods, report.planned_seconds[i], hundred * widths.mean, hundred * widths.widest,
                          hundred * widths.widest_wilson});
  }
  return table;
}

Figure cost_realisations(const CostReport& report) {
  Figure figure{.name = "cost_realisations",
                .title = "Cost of narrower intervals in time",
                .tables = {realisations_table(report)},
                .panels = {{.x = {.quantity = "processor time of the run", .unit = "s", .logarithmic = true},
                            .y = {.quantity = "half-width", .unit = "%", .logarithmic = true}}}};
  add_curve(1, "time", "widest", "widest", figure);
  add_curve(2, "time", "wilson", "widest of Wilson's", figure);
  add_curve(0, "time", "mean", "mean", figure);
  for (const auto& row : figure.tables[0].rows) {
    const double time = std::get<double>(row[2]);
    figure.panels[0].x.ticks.push_back(
        {.place = time, .text = time < 100.0 ? three_digits(time) : fixed_point(time, 0)});
  }
  figure.caption =
      "Half-width of each condition's widest simultaneous interval at 1, 4 and 16 times the requested realisations, if "
      "the shares of the response modes stay the same: widest and mean over the conditions.";
  add_title(figure, report);
  return figure;
}

}  // namespace

std::vector<Figure> cost_figures(const CostReport& report) {
  std::vector<Figure> figures{cost_tolerance(report), work_precision(report)};
  if (!report.cost.planned.empty()) figures.push_back(cost_realisations(report));
  return figures;
}

}  // namespace rocking::analysis
