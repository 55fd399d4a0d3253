#include "rocking/studies/fragility/words.hpp"

#include <cmath>

#include "rocking/output/mode_table.hpp"
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
    heading += (heading.empty() ? "" : "; ") + parameter.pointer.substr(1) + ' ' + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

}  // namespace rocking
