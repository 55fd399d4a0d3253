#include "rocking/output/parameter_text.hpp"

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// In six digits; for a number just below 1 in as many as distinguish it from 1.
std::string digits_of(double number) {
  constexpr int most_digits = 17;
  std::string text;
  for (int digits = 6; digits <= most_digits; ++digits) {
    text = significant(number, digits);
    if (text != "1" || number >= 1.0) break;
  }
  return text;
}

}  // namespace

std::string short_value(const Parameter& parameter) {
  if (const auto* number = std::get_if<double>(&parameter.value)) return digits_of(*number);
  if (const auto* word = std::get_if<std::string>(&parameter.value)) {
    // A record of a suite by its file name; what names a folder is the same for most.
    return parameter.pointer == "/excitation/file" ? word->substr(word->rfind('/') + 1) : *word;
  }
  const Json value = json_of(parameter.value);
  if (!value.is_object()) return brief(value);
  if (value.size() == 1 && value.contains("rate_ratio")) return "rate ratio " + significant(value["rate_ratio"], 6);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    if (!text.empty()) text += '/';
    text += part.is_number() ? significant(part.get<double>(), 6) : brief(part);
  }
  return text;
}

std::string values_of(const std::vector<Parameter>& parameters) {
  std::string name;
  for (const Parameter& parameter : parameters) {
    name += (name.empty() ? "" : ", ") + last_key(parameter.pointer) + ' ' + short_value(parameter);
  }
  return name;
}

look::Table table_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& further) {
  look::Table table;
  for (const Parameter& parameter : parameters) table.columns.push_back({.title = last_key(parameter.pointer)});
  add_columns(table, further);
  return table;
}

look::Row row_of(const std::vector<Parameter>& parameters, const look::Row& further) {
  look::Row row;
  for (const Parameter& parameter : parameters) row.emplace_back(short_value(parameter));
  append(row, further);
  return row;
}

}  // namespace rocking
