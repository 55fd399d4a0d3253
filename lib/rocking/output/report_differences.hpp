#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rocking {

/// Differences of two reports in `input`, `result` and `internal`, which are the same for equal input, each as `/place
/// is this, not that`; the first ten. `right` is the reference.
[[nodiscard]] std::vector<std::string> report_differences(std::string_view claimed, std::string_view right);

/// Differences of two experiments, likewise.
[[nodiscard]] std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right);

}  // namespace rocking
