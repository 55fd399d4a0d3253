#pragma once

#include <string>

#include "rocking/output/fragility_report.hpp"
#include "rocking/output/suite_table.hpp"

namespace rocking {

/// The curves as text: a table for each curve, and the fitted function.
[[nodiscard]] std::string fragility_table(const FragilityReport& report, RecordTable records = RecordTable::omitted);

}  // namespace rocking
