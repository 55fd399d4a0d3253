#include "rocking/studies/curves/look.hpp"

#include <cmath>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

using look::number;

look::Cell estimate_cell(double value, const std::optional<stats::Interval>& interval) {
  return number(value, interval, 3);
}

std::string bounded_in_words(const stats::Bounded& bounded) {
  return plain_text(estimate_cell(bounded.value, bounded.interval));
}

std::string years_in_words(double years) {
  if (!(years >= 10.0 && years < 1e9)) return significant(years, 2);
  const double unit = std::pow(10.0, std::floor(std::log10(years)) - 1.0);
  return std::to_string(std::llround(std::round(years / unit) * unit));
}

std::string test_in_words(const stats::LackOfFit& test) {
  return "lack of fit: deviance " + significant(test.deviance, 3) + ", p = " + significant(test.p_value, 2) + " (" +
         std::to_string(test.samples) + " bootstrap samples)\n";
}

std::string rare_table(const std::vector<RareLevel>& levels, const std::string& parameter) {
  if (levels.empty()) return "";
  look::Table table{.title = "rare estimates"};
  add_columns(table, {last_key(parameter), "probability", "from", "to", "error"});
  for (const RareLevel& level : levels) {
    table.rows.push_back({number(level.intensity, 6), number(level.probability, 3), number(level.interval.low, 3),
                          number(level.interval.high, 3), number(100.0 * level.relative_error, 2, " %")});
  }
  return to_terminal(table);
}

std::string heading_of_curve(const std::string& title, const std::vector<Parameter>& others) {
  std::string heading = title;
  for (const Parameter& parameter : others) {
    heading += heading.empty() ? "" : "; ";
    heading += (parameter.name.empty() ? parameter.pointer.substr(1) + ' ' : "") + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

bool are_named(const std::vector<Parameter>& option) {
  return std::ranges::any_of(option, [](const Parameter& each) { return !each.name.empty(); });
}

std::string block_of(const CurveSubject& subject) {
  const std::string option = analysis::values_in_words(subject.others);
  if (are_named(subject.others)) return option + ": the block";
  return option.empty() ? "The block" : "With " + option + " the block";
}

std::string tilt_note(const CurveSubject& subject) {
  const std::string degrees = in_degrees(subject.event, subject.balance);
  return degrees.empty() ? "" : ", " + column_of(subject.event) + degrees;
}

std::string rate_with_level(const AnnualRate& rate, double confidence) {
  return "mean annual rate " + rate_in_words(rate.value, rate.interval) +
         (rate.interval ? " (" + level_text(confidence) + " %)" : "");
}

std::string rate_in_words(double rate, const std::optional<stats::Interval>& interval) {
  return plain_text(look::number(rate, interval, look::rate_form()));
}

std::string in_years_text(double probability) { return rate_text(100.0 * probability); }

std::string at_intensity(const CurveSubject& subject, const std::string& value) {
  const analysis::Axis axis = analysis::axis_of_parameter(subject.parameter);
  return (axis.symbol.empty() ? axis.quantity + ' ' : axis.symbol + " = ") + value +
         (axis.unit.empty() ? "" : ' ' + axis.unit);
}

std::string counted_from_in_words(const CurveSubject& subject) {
  if (!subject.least_uplift) return "from all intensities";
  return "from " + at_intensity(subject, significant(*subject.least_uplift, 3)) + " on";
}

std::string why_counted_in_words(const CurveSubject& subject) {
  const std::string moves = subject.event.is_of_slip() ? "moves" : "lifts";
  return subject.least_uplift ? ", the least that " + moves + " the block"
                              : ", since the least that " + moves + " the block is not known";
}

std::string rate_sentence(const CurveSubject& subject, const AnnualRate& rate) {
  if (rate.value > 0.0) {
    return block_of(subject) + ' ' + does(subject.event) + in_degrees(subject.event, subject.balance) +
           " about once in " + years_in_words(1.0 / rate.value) +
           " years: " + rate_with_level(rate, subject.confidence);
  }
  const auto at = [&subject](double intensity) { return at_intensity(subject, significant(intensity, 3)); };
  const std::string happens = to_do(subject.event) + in_degrees(subject.event, subject.balance);
  std::string none = block_of(subject) + " did not " + happens + " at these levels: ";
  if (rate.hazard_ends) {
    const bool is_below = subject.least_uplift && *rate.hazard_ends <= *subject.least_uplift;
    none = block_of(subject) + " does not " + happens + " by this hazard curve, whose rate is 0 from " +
           at(*rate.hazard_ends) + " on" +
           (is_below ? ", below the least that lifts the block, " + at(*subject.least_uplift) : "") + ": ";
  }
  if (!rate.interval || !(rate.interval->high > 0.0)) return none + rate_with_level(rate, subject.confidence);
  return none + "mean annual rate at most " + rate_text(rate.interval->high) + " (" + level_text(subject.confidence) +
         " %), once in " + years_in_words(1.0 / rate.interval->high) + " years";
}

std::string rate_sentence(const CurveSubject& subject, const SuiteRate& rate) {
  const std::string sentence = rate_sentence(subject, rate.chosen);
  if (!(rate.chosen.value > 0.0)) return sentence;
  return sentence + "; what the levels leave open, " + undecided_in_words(rate) + ", raises it to at most " +
         rate_text(rate.at_most) + (rate.is_decided() ? "" : ": add " + added_levels_in_words(rate));
}

}  // namespace rocking
