#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/fragility.hpp"

namespace rocking {

inline constexpr std::string_view fragility_format = "rocking.fragility/1";

/// The curves of a run.
struct RunFragility {
  Experiment experiment;
  std::vector<FragilityCurve> curves;
};

/// `rocking.fragility/1` (lib/docs/formats.md).
[[nodiscard]] std::string fragility_text(const std::vector<RunFragility>& runs);

/// The curves as text: a table for each curve, and the fitted function.
[[nodiscard]] std::string fragility_table(const std::vector<RunFragility>& runs);

}  // namespace rocking
