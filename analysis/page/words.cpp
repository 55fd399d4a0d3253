#include "analysis/page/words.hpp"

#include "analysis/page/html.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {

std::string probability_text(double probability, const stats::Interval& interval) {
  return per_cent(probability) + " % " + per_cent(interval);
}

std::string place_value_html(const Parameter& parameter) {
  const Axis axis = axis_of_parameter(parameter.pointer);
  const bool has_unit = parameter.name.empty() && !axis.unit.empty();
  return escaped(short_value(parameter)) + (has_unit ? ' ' + escaped(axis.unit) : "");
}

std::string place_html(const Parameter& parameter) {
  if (!parameter.name.empty()) return place_value_html(parameter);
  const Axis axis = axis_of_parameter(parameter.pointer);
  const std::string name = axis.symbol.empty() ? escaped(axis.quantity) + ' ' : symbol_html(axis.symbol) + " = ";
  return name + place_value_html(parameter);
}

std::string condition_name(const Report& report, std::size_t condition) {
  const std::string name = name_of_condition(report, report.conditions[condition]);
  return name.empty() ? "the only condition" : name;
}

}  // namespace rocking::analysis
