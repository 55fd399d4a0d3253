#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/experiment/bifurcation.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::report {

inline constexpr std::string_view bifurcation_format = "rocking.bifurcation/1";

/// The diagrams of one realisation of an experiment.
struct DrawnDiagrams {
  const experiment::Experiment* experiment;
  std::uint64_t realisation;
  std::vector<experiment::Diagram> diagrams;
};

/// `rocking.bifurcation/1` (lib/docs/formats.md): a line for each step.
[[nodiscard]] std::string bifurcation_text(const DrawnDiagrams& drawn);

/// The strobe points as comma-separated values, a line each: parameter, branch, tilt, tilt_rate, diagram.
[[nodiscard]] std::string bifurcation_csv(const DrawnDiagrams& drawn);

/// The response modes for reading: a table for each diagram, a row for each value, a column for each branch.
[[nodiscard]] std::string bifurcation_table(const DrawnDiagrams& drawn);

}  // namespace rocking::report
