#pragma once

#include <string>

#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// HTML: which responses occur, where each is the most likely one, and how probable overturning can be.
[[nodiscard]] std::string responses_in_brief(const RunReport& report);

/// HTML: how often two runs of a condition differ, where this is most frequent, and after which time they diverge.
[[nodiscard]] std::string recurrence_in_brief(const RunReport& report);

}  // namespace rocking::analysis
