#include "analysis/table_text.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/shaking_text.hpp"

namespace rocking::analysis {
CsvStart::CsvStart(const Report& report) {
  add_columns(table_, report.swept);
  for (const std::string_view key : shown_forms(shakings_of(report))) {
    if (std::ranges::find(report.swept, "/excitation/" + std::string(key)) == report.swept.end())
      shaking_.push_back(key);
  }
  add_columns(table_, {shaking_.begin(), shaking_.end()});
  add_columns(table_, {"n"});
}

look::Table CsvStart::table(const std::vector<look::Column>& further) const {
  look::Table table = table_;
  table.columns.insert(table.columns.end(), further.begin(), further.end());
  return table;
}

look::Row CsvStart::row(const ReportedCondition& condition, const look::Row& further) const {
  look::Row row;
  for (const Parameter& parameter : condition.asked.parameters) {
    const Json value = json_of(parameter.value);
    row.emplace_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const std::string_view key : shaking_) {
    row.push_back(condition.shaking ? exact(number_of(*condition.shaking, key)) : look::Cell());
  }
  row.push_back(look::whole(condition.result.realisations));
  append(row, further);
  return row;
}

look::Cell exact(const std::optional<double>& number, const std::optional<look::Ends>& interval) {
  return look::Number{.value = number, .form = 17, .interval = interval};
}

look::Table table_of(const std::vector<ParameterColumn>& parameters, const std::vector<std::string>& further) {
  look::Table table;
  for (const ParameterColumn& column : parameters) {
    table.columns.push_back({.title = label_of(column.axis), .latex = latex_symbol(column.pointer)});
  }
  add_columns(table, further);
  return table;
}

look::Row row_of(const std::vector<ParameterColumn>& parameters, std::size_t condition, const look::Row& further) {
  look::Row row;
  for (const ParameterColumn& column : parameters) row.emplace_back(column.values[condition]);
  append(row, further);
  return row;
}

std::string latex_of(const look::Table& table, const Report& report, const std::string& caption) {
  return to_latex(table, look::latex_caption(report.title(), caption));
}

std::string latex_symbol(const std::string& pointer) {
  static const std::map<std::string, std::string> symbols{{"/excitation/amplitude", "$A_h$"},
                                                          {"/excitation/frequency_ratio", "$\\Omega_h$"},
                                                          {"/excitation/amplitude_g", "$a_h/g$"},
                                                          {"/excitation/amplitude_m_s2", "$a_h$ [m/s$^2$]"},
                                                          {"/excitation/frequency_hz", "$f$ [Hz]"},
                                                          {"/excitation/period_s", "$T$ [s]"},
                                                          {"/restitution/rate_ratio", "$\\delta$"},
                                                          {"/friction", "$\\mu_s/\\mu_k$"},
                                                          {"/friction/static", "$\\mu_s$"},
                                                          {"/friction/kinetic", "$\\mu_k$"},
                                                          {"/restitution", "$e$"}};
  const auto found = symbols.find(pointer);
  return found == symbols.end() ? look::latex_text(axis_of_parameter(pointer).quantity) : found->second;
}

}  // namespace rocking::analysis
