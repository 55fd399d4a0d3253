#pragma once

#include <string>

#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// What was asked, in two or three sentences of HTML: block, shaking, friction, what varies, how often.
[[nodiscard]] std::string question_in_brief(const RunReport& report);

/// The same as a list of every setting, with the experiment file behind it.
[[nodiscard]] std::string question_in_full(const RunReport& report);

}  // namespace rocking::analysis
