#include "analysis/page/question_values.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_named_values = 4;

dynamics::Geometry geometry_in(const ReportedCondition& condition) {
  return dynamics::geometry_of(mean_block(condition.asked.scene));
}

bool is_within(const std::string& pointer, const std::string& swept) {
  return pointer == swept || pointer.starts_with(swept + '/');
}

/// `A_h = 4.5`, `1.1 g`, `0.5 to 1.1 g` in HTML.
std::string form_html(const Report& report, std::string_view key, int digits) {
  const std::string text =
      over_conditions(report, digits, [key](const auto& each) { return number_of(*each.shaking, key); });
  if (key == "amplitude") return symbol_html("A_h") + " = " + text;
  if (key == "frequency_ratio") return "<i>&Omega;</i><sub>h</sub> = " + text;
  if (key == "amplitude_m_s2") return text + " m/s<sup>2</sup>";
  return in_unit(key, text);
}

/// What the sweep sets at this place in a condition; null if nothing.
Json swept_at(const ReportedCondition& condition, const std::string& pointer) {
  Json value;
  for (const Parameter& each : condition.asked.parameters) {
    if (!is_within(pointer, each.pointer)) continue;
    const Json whole = json_of(each.value);
    const Json::json_pointer place(pointer.substr(each.pointer.size()));
    if (whole.contains(place)) value = whole.at(place);
  }
  return value;
}

}  // namespace

std::string of_block(const Report& report, int digits, double dynamics::Geometry::*number) {
  return over_conditions(report, digits, [number](const auto& each) { return geometry_in(each).*number; });
}

std::string of_edge(const Report& report, int digits, std::size_t side, double dynamics::Edge::*number, double unit) {
  return over_conditions(report, digits,
                         [=](const auto& each) { return geometry_in(each).edges[side].*number / unit; });
}

bool is_swept(const Report& report, const std::string& pointer) {
  return std::ranges::any_of(report.swept, [&](const std::string& swept) { return is_within(pointer, swept); });
}

std::string swept_mark(const Report& report, const std::string& pointer) {
  return is_swept(report, pointer) ? " (swept)" : "";
}

std::vector<std::string_view> common_keys(const Report& report) {
  std::vector<std::string_view> keys;
  const auto& first = report.conditions.front().shaking;
  for (const auto given : {&Shaking::given_amplitude, &Shaking::given_frequency}) {
    const auto is_alike = [&](const auto& each) { return each.shaking && (*each.shaking).*given == (*first).*given; };
    if (first && std::ranges::all_of(report.conditions, is_alike)) keys.push_back((*first).*given);
  }
  return keys;
}

std::string other_form_html(const Report& report, std::string_view key) {
  return " (" + form_html(report, other_form_of(key), 3) + ')';
}

std::string both_forms_html(const Report& report, std::string_view key) {
  return form_html(report, key, 6) + other_form_html(report, key);
}

std::string setting_html(const Report& report, const std::string& pointer, const Json& value) {
  const auto text_of = [](const Json& one) { return escaped(one.is_string() ? one.get<std::string>() : brief(one)); };
  if (!is_swept(report, pointer)) return text_of(value);
  NumberRange numbers;
  bool are_numbers = true;
  std::vector<std::string> texts;
  for (const ReportedCondition& condition : report.conditions) {
    const Json own = swept_at(condition, pointer);
    are_numbers = are_numbers && own.is_number();
    if (are_numbers) numbers.add(own);
    if (own.is_null() || std::ranges::find(texts, text_of(own)) != texts.end()) continue;
    if (texts.size() <= most_named_values) texts.push_back(text_of(own));
  }
  if (texts.size() > most_named_values) texts.back() = "...";
  return are_numbers ? range_in_words(numbers, 6) : fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace rocking::analysis
