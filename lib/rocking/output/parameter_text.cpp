#include "rocking/output/parameter_text.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/mode_table.hpp"
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

constexpr std::size_t longest_name = 112;  // without the number of a later one of two

bool is_letter_or_digit(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9'); }

std::string in_safe_letters(std::string text) {
  const auto is_unsafe = [](char c) { return !is_letter_or_digit(c) && c != '.' && c != '+' && c != '-'; };
  std::ranges::replace_if(text, is_unsafe, '_');
  return text;
}

std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

/// `sigma` of `/fluctuation/friction/sigma`, or `friction_sigma` if another parameter has that last key.
std::string key_of(const std::string& pointer, const std::vector<Parameter>& all) {
  const std::string last = last_key(pointer);
  const auto has_last = [&last](const Parameter& other) { return last_key(other.pointer) == last; };
  const std::size_t parent = pointer.rfind('/');
  if (std::ranges::count_if(all, has_last) < 2 || parent == 0 || parent == std::string::npos) return last;
  return last_key(std::string_view(pointer).substr(0, parent)) + '_' + last;
}

/// A text in full, also the folder of a file; otherwise as in tables.
std::string value_in_name(const Parameter& parameter) {
  const auto* word = std::get_if<std::string>(&parameter.value);
  return word != nullptr ? *word : short_value(parameter);
}

std::string name_of(const std::vector<Parameter>& parameters) {
  std::string name;
  for (const Parameter& parameter : parameters) {
    name += (name.empty() ? "" : "_") + key_of(parameter.pointer, parameters) + '_' + value_in_name(parameter);
  }
  return in_safe_letters(name.substr(0, longest_name));
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
  if (value.size() == 1 && value.contains("rate_ratio")) {
    const Json& ratio = value["rate_ratio"];
    return "rate ratio " + (ratio.is_number() ? significant(ratio.get<double>(), 6) : brief(ratio));
  }
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

std::vector<std::string> parameter_names(std::span<const std::vector<Parameter>> parts) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::vector<Parameter>& parameters : parts) {
    const std::string wanted = name_of(parameters);
    std::string name = wanted;
    for (std::size_t number = 2; !taken.insert(in_lower_case(name)).second; ++number) {
      name = wanted + '_' + std::to_string(number);
    }
    names.push_back(std::move(name));
  }
  return names;
}

QuantityName quantity_name(const std::string& pointer) {
  static const std::map<std::string, QuantityName> known{
      {"/excitation/amplitude", {"base amplitude", "A_h", "", "$A_h$"}},
      {"/excitation/frequency_ratio", {"frequency ratio", "Ω_h", "", "$\\Omega_h$"}},
      {"/excitation/amplitude_g", {"base amplitude", "", "g", "$a_h/g$"}},
      {"/excitation/amplitude_m_s2", {"base amplitude", "", "m/s²", "$a_h$ [m/s$^2$]"}},
      {"/excitation/frequency_hz", {"base frequency", "", "Hz", "$f$ [Hz]"}},
      {"/excitation/period_s", {"base period", "", "s", "$T$ [s]"}},
      {"/restitution/rate_ratio", {"rate ratio", "δ", "", "$\\delta$"}},
      {"/restitution/rate_ratio/0", {"rate ratio of the left edge", "δ_1", ""}},
      {"/restitution/rate_ratio/1", {"rate ratio of the right edge", "δ_-1", ""}},
      {"/excitation/phase_rad", {"phase", "Φ", "rad"}},
      {"/excitation/vertical/amplitude", {"vertical amplitude", "A_v", ""}},
      {"/excitation/vertical/amplitude_g", {"vertical amplitude", "", "g"}},
      {"/excitation/vertical/amplitude_m_s2", {"vertical amplitude", "", "m/s²"}},
      {"/excitation/vertical/frequency_ratio", {"vertical frequency ratio", "Ω_v", ""}},
      {"/excitation/vertical/frequency_hz", {"vertical frequency", "", "Hz"}},
      {"/excitation/vertical/period_s", {"vertical period", "", "s"}},
      {"/excitation/vertical/phase_rad", {"vertical phase", "Φ_v", "rad"}},
      {"/excitation/scale", {"scale of the ground motion", "", ""}},
      {"/excitation/pga_g", {"peak ground acceleration", "PGA", "g"}},
      {"/excitation/sa_g", {"spectral acceleration", "PSa", "g"}},
      {"/excitation/sa_p_g", {"spectral acceleration at 2π/p", "PSa", "g"}},
      {"/excitation/avgsa_g", {"average spectral acceleration", "avgSa", "g"}},
      {"/excitation/sa_absolute_g", {"absolute spectral acceleration", "", "g"}},
      {"/excitation/pgv_m_s", {"peak ground velocity", "PGV", "m/s"}},
      {"/excitation/file", {"ground motion", "", ""}},
      {"/friction/static", {"static friction", "μ_s", "", "$\\mu_s$"}},
      {"/friction/kinetic", {"kinetic friction", "μ_k", "", "$\\mu_k$"}},
      {"/friction/kinetic/ratio", {"kinetic over static friction", "μ_k/μ_s", ""}},
      {"/friction", {"friction", "μ_s/μ_k", "", "$\\mu_s/\\mu_k$"}},
      {"/restitution", {"restitution", "e", "", "$e$"}},
      {"/block/width_m", {"width", "B", "m"}},
      {"/block/height_m", {"height", "H", "m"}},
      {"/initial/tilt", {"initial tilt", "Θ_0", ""}},
      {"/initial/tilt_rate", {"initial tilt rate", "Θ′_0", ""}},
      {"/initial/slip", {"initial slip", "X_0", ""}},
      {"/initial/slip_rate", {"initial slip rate", "V_0", ""}},
      {"/initial/tilt_rad", {"initial tilt", "θ_0", "rad"}},
      {"/initial/tilt_rate_rad_s", {"initial tilt rate", "", "rad/s"}},
      {"/initial/slip_m", {"initial slip", "", "m"}},
      {"/initial/slip_rate_m_s", {"initial slip rate", "", "m/s"}}};
  if (const auto found = known.find(pointer); found != known.end()) return found->second;
  const std::string key = last_key(pointer);
  if (key == "refresh_slip_m") return {"cell of friction", "", "m"};
  const std::string whole = pointer.substr(0, pointer.size() - std::min(pointer.size(), key.size() + 1));
  if (last_key(whole) == "normal" || last_key(whole) == "lognormal") {  // of a number that is drawn
    const std::string drawn = quantity_name(whole.substr(0, whole.rfind('/'))).quantity;
    return {.quantity = (key == "sigma" ? "standard deviation" : key) + (" of " + drawn), .symbol = "", .unit = ""};
  }
  if (key == "sigma" || key == "relative_sigma") {
    std::string of = last_key(whole);
    std::replace(of.begin(), of.end(), '_', ' ');
    return {.quantity = (key == "sigma" ? "standard deviation of " : "relative standard deviation of ") + of,
            .symbol = "σ",
            .unit = ""};
  }
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  const bool is_source = pointer == "/fluctuation/" + key;
  return {.quantity = (is_source ? "fluctuation of " : "") + words, .symbol = "", .unit = ""};
}

}  // namespace rocking
