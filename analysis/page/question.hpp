#pragma once

#include <string>

#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// The experiment in two or three sentences of HTML: block, excitation, friction, what is random and what is varied.
[[nodiscard]] std::string question_at_once(const Report& report);

/// The same with the impacts and the number of realisations.
[[nodiscard]] std::string question_in_brief(const Report& report);

/// What question_at_once omits, and a list of all settings, followed by the experiment file.
[[nodiscard]] std::string question_in_full(const Report& report);

}  // namespace rocking::analysis
