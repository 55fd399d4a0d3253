#pragma once

#include <string>
#include <string_view>

#include "rocking/output/report.hpp"

namespace rocking {

/// What clamps of a kind leave of the law of a random number, `the kinetic friction in force has mean 0.348 and sigma 0.0274,
/// not 0.35 and 0.03`. Empty if the law is not normal or not known. `key`: that of the kind of clamp in a report.
[[nodiscard]] std::string law_in_force_words(const Report& report, const ReportedCondition& condition,
                                             std::string_view key);

}  // namespace rocking
