#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/experiment/comparison.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::report {

inline constexpr std::string_view comparison_format = "rocking.comparison/1";

/// Two runs beside each other, as many conditions of each as there are comparisons.
struct ComparedRuns {
  const experiment::Experiment* first;
  const experiment::Experiment* second;
  std::vector<experiment::ConditionComparison> conditions;
};

/// `rocking.comparison/1` (lib/docs/formats.md).
[[nodiscard]] std::string comparison_text(const ComparedRuns& runs);

/// The same for reading: what differs between the experiments, then a line for each condition and mode.
[[nodiscard]] std::string comparison_table(const ComparedRuns& runs);

}  // namespace rocking::report
