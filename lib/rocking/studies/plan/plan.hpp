#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/plan/needs.hpp"
#include "rocking/studies/plan/time_estimate.hpp"

namespace rocking {

/// Size of a run before it starts.
struct Plan {
  std::string title;
  std::uint64_t conditions = 0;
  std::uint64_t realisations = 0;   ///< of all conditions
  bool at_most = false;             ///< some conditions may stop earlier
  std::uint64_t periods = 0;        ///< of all realisations together
  std::uint64_t most_periods = 0;   ///< the same if every realisation goes on to its limit; `periods` without a limit
  std::uint64_t least_periods = 0;  ///< the same if each is classified at once: with the windows that hold and watch it
  bool has_record = false;          ///< periods are those of the strobe, not of an excitation
  Needs needs;
  std::optional<TimeEstimate> time;  ///< absent: not measured, or not to be had
  std::vector<std::string> effects;  ///< that are on in at least one condition
  std::string impacts;               ///< what they leave of the tilt rate, in a sentence
};

/// The plan of a run without its time.
[[nodiscard]] Plan plan_of(const Experiment& experiment, const Means& means);

/// Time [s] if this share of the realisations goes on to its limit and the others are classified at once. The time of the
/// plan is known.
[[nodiscard]] double seconds_if_continued(const Plan& plan, double share);

}  // namespace rocking
