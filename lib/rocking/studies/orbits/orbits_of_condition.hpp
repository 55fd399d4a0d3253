#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/dynamics/termination.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/studies/orbits/orbit.hpp"

namespace rocking {

/// The orbits of a condition, and the run from its initial state.
struct OrbitsOfCondition {
  std::vector<Parameter> parameters;                                           ///< of the condition
  dynamics::Termination termination = dynamics::Termination::reached_horizon;  ///< of the run
  section::ResponseMode mode;                                                  ///< of the run
  std::optional<std::size_t> run_on;  ///< the stable orbit on which the run ended
  std::vector<Orbit> orbits;          ///< in the order in which they were found
  std::uint64_t searches = 0;         ///< Newton iterations started
  std::uint64_t converged = 0;        ///< of these, to an orbit, new or not

  /// Whether the run ended on a stable orbit of the m and n of its response; absent if that is not (m,n).
  [[nodiscard]] std::optional<bool> is_certified() const;
};

}  // namespace rocking
