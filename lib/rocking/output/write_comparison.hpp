#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/comparison.hpp"

namespace rocking {

inline constexpr std::string_view comparison_format = "rocking.comparison/1";

/// Two runs with the same number of conditions, and the comparison of each condition.
struct ComparedRuns {
  const Experiment* first;
  const Experiment* second;
  std::vector<ConditionComparison> conditions;
};

/// `rocking.comparison/1` (lib/docs/formats.md).
[[nodiscard]] std::string comparison_text(const ComparedRuns& runs);

/// The comparison as text: differences between the experiments, then a line for each condition and mode.
[[nodiscard]] std::string comparison_table(const ComparedRuns& runs);

}  // namespace rocking
