#pragma once

#include <string>

#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// HTML: when the responses of a run with `until_classified` settled: a table with a row for each condition, which limit
/// would do where it was too short, and the rates at which settled responses were left. Empty for another run.
[[nodiscard]] std::string settling_html(const Report& report);

}  // namespace rocking::analysis
