#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/fragility.hpp"

namespace rocking::report {

inline constexpr std::string_view fragility_format = "rocking.fragility/1";

/// The curves of a run.
struct RunFragility {
  experiment::Experiment experiment;
  std::vector<experiment::FragilityCurve> curves;
};

/// `rocking.fragility/1` (lib/docs/formats.md).
[[nodiscard]] std::string fragility_text(const std::vector<RunFragility>& runs);

/// The same for reading: a table for each curve, and what the law makes of it.
[[nodiscard]] std::string fragility_table(const std::vector<RunFragility>& runs);

}  // namespace rocking::report
