#include "rocking/studies/cost/study.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/look/table.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

double ratio(std::uint64_t part, std::uint64_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

std::string tolerance_name(const ToleranceCost& cost) { return significant(cost.tolerance, 3); }

look::Row row_of(const Cost& cost, std::size_t place) {
  const ToleranceCost& tolerance = cost.curve[place];
  look::Row row{tolerance_name(tolerance) + (cost.is_own(place) ? " *" : "  ")};
  if (const auto& departure = tolerance.departure) {
    const auto interval = [&cost](const std::optional<stats::Interval>& found) {
      return cost.yardstick.is_everything ? look::Cell() : look::interval(found, percentage(2));
    };
    append(row,
           {number(departure->median_error, 1), number(departure->largest_error, 1),
            number(ratio(departure->diverged, cost.sample), percentage(2)), look::whole(departure->flips.successes),
            interval(departure->flips_interval), interval(departure->beyond_floor)});
  } else {
    row.resize(row.size() + 6);
  }
  append(row, {number(tolerance.steps_per_period(), look::decimals(1)), number(1e6 * cost.seconds_per_period(place), 3),
               number(cost.speed(place), look::decimals(2))});
  return row;
}

std::string time_in_words(double seconds) {
  if (seconds < 60.0) return significant(seconds, 2) + " s";
  if (seconds < 3600.0) return significant(seconds / 60.0, 2) + " min";
  if (seconds < 48.0 * 3600.0) return significant(seconds / 3600.0, 2) + " h";
  return significant(std::round(seconds / 86400.0), 6) + " d";
}

/// `800`, or `40 to 800` if the random conditions have different numbers. At least one is random.
std::string realisations_asked_for(const Experiment& experiment, std::uint64_t factor) {
  std::vector<std::uint64_t> numbers;
  for (const Condition& condition : experiment.conditions) {
    if (is_random(condition.scene)) numbers.push_back(factor * condition.realisations);
  }
  const auto [least, most] = std::ranges::minmax(numbers);
  return least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
}

std::string realisations_table(const MeasuredCost& measured) {
  const Cost& cost = measured.cost;
  if (cost.planned.empty()) return "nothing is random: one realisation of each condition is sufficient\n";
  look::Table table;
  add_columns(table, {"realisations", "mean half-width", "widest", "Wilson's", "time"});
  for (const auto& [factor, widths, periods, seconds] : cost.planned) {
    table.rows.push_back({realisations_asked_for(*measured.experiment, factor), number(widths.mean, percentage(2)),
                          number(widths.widest, percentage(2)), number(widths.widest_wilson, percentage(2)),
                          time_in_words(seconds)});
  }
  std::string text = to_terminal(table);
  for (const auto& [half_width, needed, periods, seconds] : cost.goals) {
    text += "for " + significant(100.0 * half_width, 3) + " % in every condition: " + std::to_string(needed.by_shares) +
            " realisations, " + time_in_words(seconds) +
            "; whatever the probabilities are: " + std::to_string(needed.at_most) + '\n';
  }
  return text +
         "half-widths in per cent, of each condition's widest simultaneous interval, if the shares of the modes stay "
         "the same; time of one\nprocessor at the experiment's tolerance, without reruns and label checks\n";
}

std::string part_of_half_width(const Cost& cost) {
  const double width = *cost.yardstick.half_width;
  const double part = cost.recommendation.at_most / width;
  const std::string of = "the half-width of the intervals, " + per_cent(width, 2) + " %";
  return part < 0.95 ? "1/" + significant(std::round(1.0 / part), 4) + " of " + of
                     : significant(part, 2) + " times " + of;
}

std::string changes(const Cost& cost, const Departure& departure) {
  const Departure& floor = *cost.floor().departure;
  std::string text = std::to_string(departure.flips.successes) + " of " + std::to_string(departure.flips.trials) +
                     " response modes change";
  if (departure.beside_tolerance_sensitivity) {
    text += " (" + std::to_string(floor.flips.successes) + " at " + tolerance_name(cost.floor()) + ')';
  }
  return text;
}

std::string speed_words(const Cost& cost, std::size_t place) {
  if (cost.is_own(place)) {
    return cost.own.size() == 1 ? "It is the tolerance of the experiment." : "It is a tolerance of the experiment.";
  }
  const double speed = cost.speed(place);
  const std::string own = tolerance_name(cost.curve[cost.own.back()]) + ", the " +
                          (cost.own.size() == 1 ? "" : "tightest ") + "tolerance of the experiment";
  if (speed >= 1.005) return "It is " + fixed_point(speed, 2) + " times faster than " + own + '.';
  return "It takes " + fixed_point(1.0 / speed, 2) + " times as long as " + own + '.';
}

std::string unrecommended(const Cost& cost) {
  if (cost.yardstick.is_everything) {
    return "No tolerance can be recommended: at each of them response modes change that do not change at the next "
           "tighter one.";
  }
  return "No tolerance can be recommended: " + std::to_string(cost.sample) + " realisations are too few to decide.";
}

/// What would show that the tolerance suffices; empty if it is shown.
std::string advice(const MeasuredCost& measured) {
  const Cost& cost = measured.cost;
  const Recommendation& found = cost.recommendation;
  if (found.assurance == Assurance::shown || cost.yardstick.is_everything) return "";
  if (!cost.yardstick.half_width) return " Increase --max-time, so that every condition is measured.";
  const std::string bearable = per_cent(found.bearable, 2) + " %";
  if (!found.sample_needed)
    return " With this share of changes, no sample can show that it is less than " + bearable + '.';
  double seconds = 0.0;
  for (std::size_t i = 0; i < cost.curve.size(); ++i) {
    seconds += static_cast<double>(cost.curve[i].periods) * cost.seconds_per_period(i);
  }
  return " To show that at most " + bearable + " change requires " + std::to_string(*found.sample_needed) +
         " realisations, if the share stays the same: about " +
         time_in_words(seconds * ratio(*found.sample_needed, cost.sample)) + " of processor time.";
}

std::string blame_words(const Cost& cost) {
  if (cost.yardstick.is_everything) return ", of all realisations. ";
  return "; the tolerance causes a change of at most " + per_cent(cost.recommendation.at_most, 2) + " %, " +
         part_of_half_width(cost) + ". ";
}

std::string coarser_words(const Cost& cost) {
  const Recommendation& found = cost.recommendation;
  if (found.coarsest == found.place) return "";
  return " Coarser ones, up to " + tolerance_name(cost.curve[*found.coarsest]) +
         ", are sufficient too, but save less than a tenth of the steps.";
}

}  // namespace

std::string cost_recommendation(const MeasuredCost& measured) {
  const Cost& cost = measured.cost;
  const Recommendation& found = cost.recommendation;
  if (!found.place) return unrecommended(cost) + advice(measured);
  const ToleranceCost& chosen = cost.curve[*found.place];
  const Departure& departure = *chosen.departure;
  const bool is_shown = found.assurance == Assurance::shown;
  std::string text = "Tolerance " + tolerance_name(chosen) +
                     (is_shown ? " is recommended: " : " is not distinguishable from the tightest: ") +
                     changes(cost, departure) + blame_words(cost);
  if (departure.median_error) {
    text += "Error in the first " + std::to_string(cost_error_periods) +
            " periods: " + significant(*departure.median_error, 1) + " (median). ";
  }
  return text + speed_words(cost, *found.place) + coarser_words(cost) + advice(measured);
}

std::string cost_table(const MeasuredCost& measured) {
  const Cost& cost = measured.cost;
  look::Table table;
  add_columns(table, {"tolerance  ", "median error", "largest", "diverged", "changed", "interval",
                      "beyond " + tolerance_name(cost.floor()), "steps", "us", "speed"});
  for (std::size_t i = 0; i < cost.curve.size(); ++i) table.rows.push_back(row_of(cost, i));
  return cost_recommendation(measured) + "\n\n" + to_terminal(table) + '\n' + std::to_string(cost.sample) +
         " realisations of " + std::to_string(cost.sampled_conditions) +
         " conditions with the same random numbers as the reference, which is the last line. Error: of the first " +
         std::to_string(cost_error_periods) +
         " periods;\ndiverged: motions that diverged before the horizon, per cent; changed: response modes, with the "
         "exact " +
         level_text(cost.confidence) +
         " % interval of their\nshare, and of its excess over that at the second tightest tolerance, per cent; steps "
         "and processor time per period, with\n" +
         std::to_string(cost.timing.realisations) + " realisations of up to " + std::to_string(cost.timing.periods) +
         " periods on each thread; speed relative to that at the " + (cost.own.size() == 1 ? "" : "tightest ") +
         "tolerance of the experiment (*)\n\n" + realisations_table(measured);
}

}  // namespace rocking
