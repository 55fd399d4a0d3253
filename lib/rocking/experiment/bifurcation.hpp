#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/dynamics/termination.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/run.hpp"
#include "rocking/section/period.hpp"
#include "rocking/section/verdict.hpp"

/// Responses against a swept parameter, where several may coexist.
namespace rocking::experiment {

/// How a step of a diagram begins: each from the file's initial state, or where the one before it ended, with the parameter
/// growing or falling from step to step.
enum class Branch : std::uint8_t { initial, upwards, downwards };
inline constexpr std::array all_branches{Branch::initial, Branch::upwards, Branch::downwards};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(Branch branch);

/// One value of the parameter on one branch.
struct DiagramStep {
  std::size_t condition = 0;  ///< of the experiment
  bool continued = false;     ///< began where the step before it ended, not from the file's initial state
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Verdict verdict;
  std::vector<section::StrobePoint> points;  ///< of the sampled periods; none where the horizon was not reached
};

/// The first entry of a sweep at fixed values of the others.
struct Diagram {
  std::vector<std::size_t> conditions;  ///< of the experiment, by growing value of the parameter
  /// By Branch, then as `conditions`.
  std::array<std::vector<DiagramStep>, all_branches.size()> branches;
};

/// The value of the first swept parameter; absent where it is no number.
[[nodiscard]] std::optional<double> diagram_value(const Condition& condition);

/// What of an experiment each diagram shows, without branches. Throws base::InputError where there is no sweep, where a value
/// of its first entry is no number, or where a base motion is recorded (its responses do not repeat).
[[nodiscard]] std::vector<Diagram> diagrams_of(const Experiment& experiment);

/// The diagrams of one realisation of an experiment; absent if it was asked to stop before the end. Progress is told in steps.
///
/// Continuation hands on the state of the block (theta, its rate, V, the contact state), the instant within the period, the
/// count of periods, and the counts of stops and impacts from which draws follow: at a constant parameter it is one long run,
/// whose Taylor steps end at each handing over. After a run that did not reach its horizon, as one that overturned, the
/// next step begins from the file's initial state.
///
/// Throws as diagrams_of. The result depends on the experiment and the realisation alone.
[[nodiscard]] std::optional<std::vector<Diagram>> bifurcation(const Experiment& experiment, std::uint64_t realisation,
                                                              const RunOptions& options);

}  // namespace rocking::experiment
