#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/write_suite.hpp"
#include "rocking/studies/run_fragility.hpp"

namespace rocking {

inline constexpr std::string_view fragility_format = "rocking.fragility/1";

/// `rocking.fragility/1` (lib/docs/formats.md).
[[nodiscard]] std::string fragility_text(const std::vector<RunFragility>& runs);

/// The curves as text: a table for each curve, and the fitted function.
[[nodiscard]] std::string fragility_table(const std::vector<RunFragility>& runs,
                                          RecordTable records = RecordTable::omitted);

}  // namespace rocking
