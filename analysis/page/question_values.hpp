#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/parameter_text.hpp"
#include "rocking/output/report.hpp"
#include "rocking/text/json.hpp"

/// Numbers and settings of all conditions of a run, as the question of its page states them.
namespace rocking::analysis {

/// A number of each condition: `0.5 to 2`.
template <class NumberOf>
[[nodiscard]] std::string over_conditions(const Report& report, int digits, const NumberOf& number_of_condition) {
  NumberRange range;
  for (const ReportedCondition& condition : report.conditions) range.add(number_of_condition(condition));
  return range_in_words(range, digits);
}

/// Of the mean blocks.
[[nodiscard]] std::string of_block(const Report& report, int digits, double dynamics::Geometry::*number);

/// Of an edge, 0 left and 1 right. `unit`: by which the number is divided.
[[nodiscard]] std::string of_edge(const Report& report, int digits, std::size_t side, double dynamics::Edge::*number,
                                  double unit = 1.0);

[[nodiscard]] bool is_swept(const Report& report, const std::string& pointer);
/// ` (swept)`, or nothing.
[[nodiscard]] std::string swept_mark(const Report& report, const std::string& pointer);

/// The keys by which every condition gives its amplitude and its frequency, without one in which they differ.
[[nodiscard]] std::vector<std::string_view> common_keys(const Report& report);

/// The amplitude or the frequency as the file gives it, with the other form, in HTML: `A_h = 4.5 (1.1 g)`.
[[nodiscard]] std::string both_forms_html(const Report& report, std::string_view key);
/// The other form alone: ` (1.1 g)`.
[[nodiscard]] std::string other_form_html(const Report& report, std::string_view key);

/// The values of a setting in all conditions: `0.8 to 1.2`, or the first few; if it is not swept, its value.
[[nodiscard]] std::string setting_html(const Report& report, const std::string& pointer, const Json& value);

}  // namespace rocking::analysis
