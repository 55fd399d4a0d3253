#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/dynamics/termination.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/period.hpp"

/// Bifurcation diagrams: responses against a swept parameter, where several may coexist.
namespace rocking {

/// Start of the steps of a branch: the initial state of the file, or the end of the previous step, with the parameter
/// increasing or decreasing from step to step.
enum class Branch : std::uint8_t { initial, upwards, downwards };
inline constexpr std::array all_branches{Branch::initial, Branch::upwards, Branch::downwards};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(Branch branch);

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
  /// By Branch, then as `conditions`.
  std::array<std::vector<DiagramStep>, all_branches.size()> branches;
};

/// The value of the first swept parameter; absent if it is not a number.
[[nodiscard]] std::optional<double> diagram_value(const Condition& condition);

/// The conditions of each diagram of an experiment, without branches. Throws base::InputError if there is no sweep, if
/// a value of its first entry is not a number, or if a base motion is recorded (its responses do not repeat).
[[nodiscard]] std::vector<Diagram> diagrams_of(const Experiment& experiment);

/// The diagrams of one realisation of an experiment; absent if it was asked to stop before the end. Progress is counted
/// in steps.
///
/// A continuation keeps the state of the block (theta, its rate, V, the contact state), the instant within the period,
/// the count of periods, and the counts of stops and impacts that select draws: at a constant parameter it is one long
/// run, with an end of a Taylor step between two steps of the diagram. After a run that did not reach its horizon, for
/// example because it overturned, the next step starts from the initial state of the file.
///
/// Throws as diagrams_of. The result depends on the experiment and the realisation alone.
[[nodiscard]] std::optional<std::vector<Diagram>> bifurcation(const Experiment& experiment, std::uint64_t realisation,
                                                              const RunOptions& options);

}  // namespace rocking
