#pragma once

#include <string>

#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Which responses occur, where each is the most likely one, and how likely overturning can be: HTML.
[[nodiscard]] std::string responses_in_brief(const RunReport& report);

/// How often two runs of one condition differ, where most, and after how long they part: HTML.
[[nodiscard]] std::string recurrence_in_brief(const RunReport& report);

}  // namespace rocking::analysis
