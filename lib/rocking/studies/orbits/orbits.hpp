#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/orbit.hpp"
#include "rocking/studies/orbits/question.hpp"

/// Periodic orbits of conditions with harmonic excitation in which nothing is random, stable and unstable ones.
namespace rocking {

/// Largest period for which orbits are searched, unless the run has a longer one.
inline constexpr int default_longest_orbit = 5;

/// The orbits of one condition: Newton's method from the end of its run, and from a grid of 9 x 9 states with Theta in
/// -0.8 ... 0.8 and Theta' in -1.2 ... 1.2 (with friction, from their images after a period, which may slip), for each
/// period up to `longest`. An orbit that is not symmetric is listed with its mirror image. The grid is finite: there
/// may be more orbits. Precondition: the condition passes check_orbits.
/// Throws base::InputError if check_condition does, and base::Stopped if it is asked to stop.
[[nodiscard]] OrbitsOfCondition orbits_of(const Condition& condition, int longest, base::StopRequest stop = {});

/// Adds an orbit and, if it is not symmetric, its mirror image, unless they are listed. Place of the orbit.
std::size_t add_orbit(OrbitsOfCondition& found, const PoincareMap& map, Orbit orbit, base::StopRequest stop);

/// Throws base::InputError if a condition is random or its excitation is not harmonic.
void check_orbits(const Experiment& experiment);

/// The orbits of all conditions of an experiment, in their order; absent if it was asked to stop before the end.
/// Progress is counted in conditions. Throws as check_orbits. The result depends on the experiment and `longest` alone.
[[nodiscard]] std::optional<std::vector<OrbitsOfCondition>> orbits(const Experiment& experiment, int longest,
                                                                   const RunOptions& options);

}  // namespace rocking
