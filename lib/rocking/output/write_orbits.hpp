#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/orbits.hpp"

namespace rocking {

inline constexpr std::string_view orbits_format = "rocking.orbits/1";

/// The orbits of an experiment.
struct FoundOrbits {
  const Experiment* experiment;
  int longest;                                ///< largest period searched from the grid
  std::vector<OrbitsOfCondition> conditions;  ///< of the experiment
};

/// `rocking.orbits/1` (lib/docs/formats.md): a line for each orbit.
[[nodiscard]] std::string orbits_text(const FoundOrbits& found);

/// The orbits as text: a row for each orbit.
[[nodiscard]] std::string orbits_table(const FoundOrbits& found);

}  // namespace rocking
