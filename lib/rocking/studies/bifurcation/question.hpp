#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"

/// Bifurcation diagrams: responses against a swept parameter, where several may coexist.
namespace rocking {

/// Start of the steps of a branch: the initial state of the file, or the end of the previous step, with the parameter
/// increasing or decreasing from step to step.
enum class DiagramBranch : std::uint8_t { initial, upwards, downwards };
inline constexpr std::array all_branches{DiagramBranch::initial, DiagramBranch::upwards, DiagramBranch::downwards};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> branch_names{"initial", "upwards", "downwards"};
[[nodiscard]] constexpr std::string_view to_string(DiagramBranch branch) {
  return branch_names[static_cast<std::size_t>(branch)];
}

/// One value of the parameter on one branch.
struct DiagramStep {
  std::size_t condition = 0;  ///< of the experiment
  bool continued = false;     ///< started at the end of the previous step, not from the initial state of the file
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Classification classification;
  std::vector<section::StrobePoint> points;  ///< of the sampled periods; none where the horizon was not reached
};

/// A diagram: the values of the first entry of a sweep, at fixed values of the others.
struct Diagram {
  std::vector<std::size_t> conditions;  ///< of the experiment, by increasing value of the parameter
  /// By DiagramBranch, then as `conditions`.
  std::array<std::vector<DiagramStep>, all_branches.size()> branches;
};

/// Bifurcation diagrams of one realisation: for each combination of values of the sweep's entries after the first, the
/// responses along the first, from the initial state and from the end of the step before, upwards and downwards. Strobe
/// points are dimensionless. Throws base::InputError if there is no sweep, if its first entry takes values that are not
/// numbers, or if an excitation is not periodic, and base::Stopped if it is asked to stop. Uses `threads`,
/// `on_progress` and `stop` of the execution; progress counts steps. The result depends on the experiment and the
/// realisation alone.
///
/// A continuation keeps the state of the block (theta, its rate, V, the contact state), the instant within the period,
/// the count of periods, and the counts of stops and impacts that select draws: at a constant parameter it is one long
/// run, with an end of a Taylor step between two steps of the diagram. After a run that did not reach its horizon, for
/// example because it overturned, the next step starts from the initial state of the file.
[[nodiscard]] ROCKING_API std::vector<Diagram> bifurcation(const Experiment& experiment, std::uint64_t realisation = 0,
                                                           const Execution& execution = {});

}  // namespace rocking
