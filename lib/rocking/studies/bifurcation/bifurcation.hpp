#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/bifurcation/question.hpp"

/// Bifurcation diagrams: responses against a swept parameter, where several may coexist.
namespace rocking {

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
