#pragma once

#include <string>

#include "rocking/look/text_table.hpp"
#include "rocking/studies/fragility/result.hpp"
#include "rocking/studies/fragility/suite_table.hpp"

namespace rocking {

/// The curves as text: of each the rate, the fitted function, and its tables. On one screen of many curves a row for each.
[[nodiscard]] std::string fragility_table(const FragilityReport& report, RecordTable records = RecordTable::omitted,
                                          Extent extent = Extent::all);

}  // namespace rocking
