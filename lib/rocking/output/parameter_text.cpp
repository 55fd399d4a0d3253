#include "rocking/output/parameter_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/scene/experiment_keys.hpp"
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

/// Units of the numbers whose keys end so; the longest first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> unit_endings{{{"_m_s2", "m/s²"},
                                                                                      {"_rad_s", "rad/s"},
                                                                                      {"_m_s", "m/s"},
                                                                                      {"_kg", "kg"},
                                                                                      {"_rad", "rad"},
                                                                                      {"_deg", "degrees"},
                                                                                      {"_hz", "Hz"},
                                                                                      {"_g", "g"},
                                                                                      {"_m", "m"},
                                                                                      {"_s", "s"}}};

/// `centre height` and `m` of `centre_height_m`.
std::pair<std::string, std::string> words_and_unit(std::string key) {
  const auto unit = std::ranges::find_if(unit_endings, [&key](const auto& each) { return key.ends_with(each.first); });
  if (unit != unit_endings.end()) key.resize(key.size() - unit->first.size());
  std::ranges::replace(key, '_', ' ');
  return {key, std::string(unit == unit_endings.end() ? "" : unit->second)};
}

/// Null of a place that has no name of its own.
const NamedPlace* named_place(const std::string& pointer) {
  static constexpr std::array<NamedPlace, 6> others{
      {{"/block/p_rad_s", "frequency parameter", "p"},
       {"/block/slenderness_rad", "slenderness", "ψ"},
       {"/friction", "friction", "μ_s/μ_k"},
       {"/friction/kinetic/ratio", "kinetic over static friction", "μ_k/μ_s"},
       {"/restitution", "restitution", "e"},
       {"/excitation/file", "ground motion"}}};
  for (const std::span<const NamedPlace> places :
       {std::span<const NamedPlace>(places_of_quantities()), std::span<const NamedPlace>(others)}) {
    const auto found = std::ranges::find(places, pointer, &NamedPlace::place);
    if (found != places.end()) return &*found;
  }
  return nullptr;
}

/// Of a law that is given by it and reaches as far as it does; absent otherwise.
std::optional<double> standard_deviation_in(const Quantity& quantity) {
  if (const auto* normal = std::get_if<Normal>(&quantity); normal != nullptr && !normal->between) return normal->sigma;
  if (const auto* lognormal = std::get_if<Lognormal>(&quantity)) return lognormal->sigma;
  return std::nullopt;
}

}  // namespace

std::string short_value(const Parameter& parameter) {
  if (!parameter.name.empty()) return parameter.name;
  if (const auto* number = std::get_if<double>(&parameter.value)) return digits_of(*number);
  if (const auto* word = std::get_if<std::string>(&parameter.value)) {
    // A record of a suite by its file name; what names a folder is the same for most.
    return parameter.pointer == "/excitation/file" ? word->substr(word->rfind('/') + 1) : *word;
  }
  const Json value = json_of(parameter.value);
  if (!value.is_object()) return brief(value);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    if (!text.empty()) text += '/';
    if (value.size() == 1) text = words_and_unit(key).first + ' ';  // of several forms
    text += part.is_number() ? significant(part.get<double>(), 6) : brief(part);
  }
  return text;
}

std::string value_in_words(const Parameter& parameter) {
  if (!parameter.name.empty()) return parameter.name;
  const QuantityName name = quantity_name(parameter.pointer);
  return name.quantity + ' ' + short_value(parameter) + (name.unit.empty() ? "" : ' ' + name.unit);
}

Json applied(Json experiment, const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    experiment[Json::json_pointer(parameter.pointer)] = json_of(parameter.value);
  }
  return experiment;
}

std::string range_in_words(const NumberRange& range, int digits) {
  const std::string low = significant(range.least, digits);
  const std::string high = significant(range.largest, digits);
  return low == high ? low : low + " to " + high;
}

std::string quantity_in_words(const Quantity& quantity) {
  if (!is_drawn(quantity)) return significant(mean_of(quantity), 6);
  const std::string law(law_names.at(quantity.index() - 1));
  if (const auto sigma = standard_deviation_in(quantity)) {
    return significant(mean_of(quantity), 3) + " (drawn, " + (law == Normal::name ? "" : law + ", ") +
           "standard deviation " + significant(*sigma, 3) + ')';
  }
  const Reach reach = reach_of(quantity);
  return significant(reach.least, 3) + " to " + significant(reach.largest, 3) +
         (law == Uniform::name ? " (drawn)" : " (drawn, " + law + ')');
}

std::string values_of(const std::vector<Parameter>& parameters) {
  std::string name;
  for (const Parameter& parameter : parameters) {
    name += name.empty() ? "" : ", ";
    name += (parameter.name.empty() ? last_key(parameter.pointer) + ' ' : "") + short_value(parameter);
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
  const std::string key = last_key(pointer);
  const auto [words, unit] = words_and_unit(key);
  if (const NamedPlace* const named = named_place(pointer)) {
    return {std::string(named->name), std::string(named->symbol), unit};
  }
  const std::string whole = pointer.substr(0, pointer.size() - std::min(pointer.size(), key.size() + 1));
  if (last_key(whole) == "normal" || last_key(whole) == "lognormal") {  // of a number that is drawn
    const std::string drawn = quantity_name(whole.substr(0, whole.rfind('/'))).quantity;
    return {.quantity = (key == "sigma" ? "standard deviation" : key) + (" of " + drawn), .symbol = "", .unit = ""};
  }
  if (key == "sigma" || key == "relative_sigma") {
    const std::string of = words_and_unit(last_key(whole)).first;
    return {.quantity = (key == "sigma" ? "standard deviation of " : "relative standard deviation of ") + of,
            .symbol = "σ",
            .unit = ""};
  }
  return {.quantity = (pointer == "/fluctuation/" + key ? "fluctuation of " : "") + words, .symbol = "", .unit = unit};
}

}  // namespace rocking
