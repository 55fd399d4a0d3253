#pragma once

#include <map>
#include <set>
#include <string>

#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// The tables of a report in the formats `csv` and `latex`, as far as they are asked for: text by the name of the file.
[[nodiscard]] std::map<std::string, std::string> table_files(const Report& report,
                                                             const std::set<std::string>& formats);

}  // namespace rocking::analysis
