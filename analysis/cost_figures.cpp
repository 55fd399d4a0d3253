#include "analysis/cost_figures.hpp"

#include <cstdint>
#include <string>

#include "analysis/data_file.hpp"
#include "analysis/output_file.hpp"
#include "analysis/palette.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr double micro = 1e6;
constexpr double hundred = 100.0;

/// A number that can be drawn on a logarithmic axis, or nothing.
Cell positive(const Json& number) {
  if (number.is_null() || number.get<double>() <= 0.0) return {};
  return number.get<double>();
}

Cell share(const Json& number) { return hundred * number.get<double>(); }

std::string spoken(double number) { return significant(number, 3); }

double own_tolerance(const Json& output) { return output.at("input").at("experiment").at("accuracy").at("tolerance"); }

std::string own_tolerance_in_words(const Json& output) {
  for (const Json& entry : output.at("input").at("experiment").value("sweep", Json::array())) {
    if (entry.at("parameter") == "/accuracy/tolerance") return "The experiment sweeps its tolerance.";
  }
  return "The experiment's own tolerance is " + spoken(own_tolerance(output)) + ".";
}

/// Processor time per period for tolerance number `i` [us].
double time_of(const Json& output, std::size_t i) {
  return micro * output.at("system").at("processor_s_per_period").at(i).get<double>();
}

/// Columns: tolerance, median, largest, changed, low, high, time, and the tolerance as text.
Table tolerance_table(const Json& output) {
  Table table{
      .name = "tolerances",
      .columns = {{"tolerance", "tolerance of the steps"},
                  {"median_error", "median over the realisations of the largest error in the first periods"},
                  {"largest_error", "the largest of all realisations"},
                  {"changed", "response modes that differ from those at the tightest tolerance [%]"},
                  {"changed_low", "lower end of its exact interval [%]; absent if all realisations were measured"},
                  {"changed_high", "upper end of its exact interval [%]"},
                  {"time", "processor time per period [us]"},
                  {"name", "the tolerance, as text"}},
      .rows = {}};
  const Json& tolerances = output.at("result").at("tolerances");
  const bool is_everything = output.at("result").at("sample").at("is_everything");
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    const double tolerance = tolerances.at(i).at("tolerance");
    const Json& departure = tolerances.at(i).at("departure");
    std::vector<Cell> row{tolerance, {}, {}, {}, {}, {}, time_of(output, i), spoken(tolerance)};
    if (!departure.is_null()) {
      row[1] = positive(departure.at("error").at("median"));
      row[2] = positive(departure.at("error").at("largest"));
      const Json& flips = departure.at("flips");
      row[3] = hundred * flips.at("count").get<double>() / flips.at("of").get<double>();
      if (!is_everything) {
        row[4] = share(flips.at("interval").at(0));
        row[5] = share(flips.at("interval").at(1));
      }
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Layer curve(std::size_t number, std::vector<std::size_t> columns, std::string legend) {
  return {.kind = LayerKind::line,
          .table = 0,
          .columns = std::move(columns),
          .style = style_of_curve(number),
          .legend = std::move(legend)};
}

void add_title(Figure& figure, const Json& output) {
  figure.subtitle = output.at("input").at("experiment").at("title").get<std::string>();
  const Json& sample = output.at("result").at("sample");
  figure.caption += " Of " + std::to_string(sample.at("realisations").get<std::uint64_t>()) + " realisations of " +
                    std::to_string(sample.at("conditions").get<std::uint64_t>()) +
                    " conditions; times of one processor.";
}

Axis tolerance_axis() { return {.quantity = "tolerance", .symbol = "", .unit = "", .logarithmic = true}; }

Figure cost_tolerance(const Json& output) {
  Figure figure;
  figure.name = "cost_tolerance";
  figure.title = "Effect and cost of a tolerance";
  figure.arrangement = Arrangement::stacked;
  figure.tables = {tolerance_table(output)};
  figure.panels = {
      {.title = "",
       .x = tolerance_axis(),
       .y = {.quantity = "error", .symbol = "", .unit = "", .logarithmic = true},
       .layers = {curve(0, {0, 1}, "median"), curve(1, {0, 2}, "largest")}},
      {.title = "",
       .x = tolerance_axis(),
       .y = {.quantity = "changed modes", .symbol = "", .unit = "%", .low = 0.0},
       .layers = {curve(0, {0, 3}, ""),
                  {.kind = LayerKind::error_bars, .table = 0, .columns = {0, 3, 4, 5}, .style = style_of_curve(0)}}},
      {.title = "",
       .x = tolerance_axis(),
       .y = {.quantity = "time per period", .symbol = "", .unit = "µs", .low = 0.0},
       .layers = {curve(0, {0, 6}, "")}}};
  figure.caption = "Error: largest difference from the tightest tolerance in Θ, Θ′, V over the first " +
                   std::to_string(output.at("result").at("error_periods").get<std::int64_t>()) +
                   " periods. Changed modes with the exact interval of a sample. " + own_tolerance_in_words(output);
  add_title(figure, output);
  return figure;
}

Figure work_precision(const Json& output) {
  Figure figure;
  figure.name = "work_precision";
  figure.title = "Cost of accuracy in time";
  figure.tables = {tolerance_table(output)};
  figure.panels = {{.title = "",
                    .x = {.quantity = "error in the first periods", .symbol = "", .unit = "", .logarithmic = true},
                    .y = {.quantity = "processor time per period", .symbol = "", .unit = "µs", .low = 0.0},
                    .layers = {curve(0, {1, 6}, "median"), curve(1, {2, 6}, "largest")}}};
  figure.caption = "One point for each tolerance from " + cell_text(figure.tables[0].rows.front()[7]) + " to " +
                   cell_text(figure.tables[0].rows[figure.tables[0].rows.size() - 2][7]) +
                   "; tighter tolerances are to the left.";
  add_title(figure, output);
  return figure;
}

/// Columns: factor, periods, time, mean half-width, largest half-width, Wilson's.
Table realisations_table(const Json& output) {
  Table table{
      .name = "realisations",
      .columns = {{"factor", "factor on the number of realisations of the experiment"},
                  {"periods", "of the whole run"},
                  {"time", "processor time at the experiment's tolerance [s]"},
                  {"mean", "half-width of a condition's widest simultaneous interval, mean over conditions [%]"},
                  {"widest", "the largest over all conditions [%]"},
                  {"wilson", "the largest half-width of Wilson's intervals [%]"}},
      .rows = {}};
  const Json& tolerances = output.at("result").at("tolerances");
  double time = 0.0;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    if (tolerances.at(i).at("tolerance") == own_tolerance(output)) time = time_of(output, i) / micro;
  }
  const Json& system = output.at("system");
  const Json& all_planned = output.at("result").at("realisations");
  for (std::size_t i = 0; i < all_planned.size(); ++i) {
    const Json& planned = all_planned.at(i);
    const double periods = planned.at("periods");
    // Files of earlier versions lack the time of the run.
    const double run_time =
        system.contains("planned_processor_s") ? system.at("planned_processor_s").at(i).get<double>() : time * periods;
    table.rows.push_back({planned.at("factor").get<double>(), periods, run_time, share(planned.at("half_width_mean")),
                          share(planned.at("half_width_widest")), share(planned.at("wilson_widest"))});
  }
  return table;
}

Figure cost_realisations(const Json& output) {
  Figure figure;
  figure.name = "cost_realisations";
  figure.title = "Cost of narrower intervals in time";
  figure.tables = {realisations_table(output)};
  figure.panels = {
      {.title = "",
       .x = {.quantity = "processor time of the run", .symbol = "", .unit = "s", .logarithmic = true},
       .y = {.quantity = "half-width", .symbol = "", .unit = "%", .logarithmic = true},
       .layers = {curve(1, {2, 4}, "widest"), curve(2, {2, 5}, "widest of Wilson's"), curve(0, {2, 3}, "mean")}}};
  for (const auto& row : figure.tables[0].rows) {
    const double time = std::get<double>(row[2]);
    figure.panels[0].x.ticks.push_back({.place = time, .text = time < 100.0 ? spoken(time) : fixed_point(time, 0)});
  }
  figure.caption =
      "Half-width of each condition's widest simultaneous interval at 1, 4 and 16 times the requested realisations, if "
      "the shares of the response modes stay the same: widest and mean over the conditions.";
  add_title(figure, output);
  return figure;
}

}  // namespace

std::vector<Figure> cost_figures(const Json& output) {
  std::vector<Figure> figures;
  read_or_refuse(output, [&] {
    figures = {cost_tolerance(output), work_precision(output)};
    if (!output.at("result").at("realisations").empty()) figures.push_back(cost_realisations(output));
  });
  return figures;
}

}  // namespace rocking::analysis
