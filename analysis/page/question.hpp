#pragma once

#include <string>

#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// The experiment in two or three sentences of HTML: block, excitation, friction, what is varied, number of
/// realisations.
[[nodiscard]] std::string question_in_brief(const Report& report);

/// A list of all settings, followed by the experiment file.
[[nodiscard]] std::string question_in_full(const Report& report);

}  // namespace rocking::analysis
