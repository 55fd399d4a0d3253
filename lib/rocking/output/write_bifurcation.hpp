#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/bifurcation.hpp"

namespace rocking {

inline constexpr std::string_view bifurcation_format = "rocking.bifurcation/1";

/// The diagrams of one realisation of an experiment.
struct DrawnDiagrams {
  const Experiment* experiment;
  std::uint64_t realisation;
  std::vector<Diagram> diagrams;
};

/// `rocking.bifurcation/1` (lib/docs/formats.md): a line for each step.
[[nodiscard]] std::string bifurcation_text(const DrawnDiagrams& drawn);

/// The strobe points as comma-separated values, one per line: parameter, branch, tilt, tilt_rate, diagram.
[[nodiscard]] std::string bifurcation_csv(const DrawnDiagrams& drawn);

/// The response modes as text: a table for each diagram, a row for each value, a column for each branch.
[[nodiscard]] std::string bifurcation_table(const DrawnDiagrams& drawn);

}  // namespace rocking
