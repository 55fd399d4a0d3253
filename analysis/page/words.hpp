#pragma once

#include <string>

#include "rocking/output/report.hpp"

/// Numbers and names as a page writes them. Only the names of conditions need escaping.
namespace rocking::analysis {

/// `98.5 % [94.4, 99.8]`.
[[nodiscard]] std::string probability_text(double probability, const stats::Interval& interval);

/// A value of a swept parameter as HTML, with its unit: `4.5`, `1.05 g`.
[[nodiscard]] std::string place_value_html(const Parameter& parameter);

/// The same with the symbol of the parameter, or with its name if it has none: `A_h = 4.5`, `scale of the ground motion
/// 0.5`.
[[nodiscard]] std::string place_html(const Parameter& parameter);

/// `friction 0.35/0.3, base amplitude 4.5`, or `the only condition`.
[[nodiscard]] std::string condition_name(const Report& report, std::size_t condition);

}  // namespace rocking::analysis
