#pragma once

#include <cstdint>
#include <string>

#include "analysis/run_report.hpp"

/// Numbers and names as a page writes them. Only the names of conditions need escaping.
namespace rocking::analysis {

/// `98.5 % [94.4, 99.8]`.
[[nodiscard]] std::string probability_text(double probability, const stats::Interval& interval);

/// Explains a response mode to a reader who is new to it: `rocks once in three periods`.
[[nodiscard]] std::string meaning_of(const section::ResponseMode& mode);

/// `friction 0.35/0.3, base amplitude 4.5`, or `the only condition`.
[[nodiscard]] std::string condition_name(const RunReport& report, std::size_t condition);

}  // namespace rocking::analysis
