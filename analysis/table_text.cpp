#include "analysis/table_text.hpp"

#include <algorithm>
#include <map>

#include "analysis/data_file.hpp"
#include "rocking/base/error.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/shaking_text.hpp"

namespace rocking::analysis {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::string csv_number(const std::optional<double>& number) { return number ? number_text(*number) : ""; }

CsvStart::CsvStart(const Report& report) {
  const std::vector<std::string> swept = report.swept;
  for (const std::string& pointer : swept) head_ += csv_field(pointer) + ',';
  for (const std::string_view key : shown_forms(shakings_of(report))) {
    if (std::ranges::find(swept, "/excitation/" + std::string(key)) != swept.end()) continue;
    shaking_.push_back(key);
    head_ += std::string(key) + ',';
  }
  head_ += 'n';
}

std::string CsvStart::of(const ReportedCondition& condition) const {
  std::string text;
  for (const Parameter& parameter : condition.parameters) {
    const Json value = value_of(parameter);
    text += csv_field(value.is_string() ? value.get<std::string>() : value.dump()) + ',';
  }
  for (const std::string_view key : shaking_) {
    text += (condition.shaking ? number_text(number_of(*condition.shaking, key)) : "") + ',';
  }
  return text + std::to_string(condition.result.realisations);
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
  return found == symbols.end() ? latex_text(axis_of_parameter(pointer).quantity) : found->second;
}

}  // namespace rocking::analysis
