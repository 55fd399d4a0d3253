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
#include "rocking/section/response_mode.hpp"
#include "rocking/studies/orbits/fixed_point.hpp"
#include "rocking/studies/orbits/stability.hpp"

/// Periodic orbits of conditions with harmonic excitation in which nothing is random, stable and unstable ones.
namespace rocking {

/// What the search for an orbit started from: the end of the condition's run, a start of the grid, or the mirror image
/// of an orbit found.
enum class FoundBy : std::uint8_t { run, grid, mirror };
inline constexpr std::array all_found_by{FoundBy::run, FoundBy::grid, FoundBy::mirror};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(FoundBy found_by);

/// A periodic orbit.
struct Orbit {
  int period = 0;                    ///< n: excitation periods until it repeats, the smallest number
  int cycles = 0;                    ///< m: pairs of impacts in them, rounded up
  std::vector<SectionState> points;  ///< at the n instants of the section
  double residual = 0.0;             ///< of the map over n periods, from the first point
  Stability stability;
  FoundBy found_by = FoundBy::run;
  std::size_t mirror = 0;  ///< place of its mirror image in the list: its own if it is symmetric
};

/// The orbits of a condition, and the run from its initial state.
struct OrbitsOfCondition {
  dynamics::Termination termination = dynamics::Termination::reached_horizon;  ///< of the run
  section::ResponseMode mode;                                                  ///< of the run
  std::optional<std::size_t> run_on;  ///< the stable orbit on which the run ended
  std::vector<Orbit> orbits;          ///< in the order in which they were found
  std::uint64_t searches = 0;         ///< Newton iterations started
  std::uint64_t converged = 0;        ///< of these, to an orbit, new or not
};

/// Largest period for which orbits are searched, unless the run has a longer one.
inline constexpr int default_longest_orbit = 5;

/// Whether two cycles are the same one, up to a shift by whole periods and the residual.
[[nodiscard]] bool is_same_cycle(const std::vector<SectionState>& a, const std::vector<SectionState>& b);

/// The orbits of one condition: Newton's method from the end of its run, and from a grid of 9 x 9 states with Theta in
/// -0.8 ... 0.8 and Theta' in -1.2 ... 1.2 (with friction, from their images after a period, which may slip), for each
/// period up to `longest`. An orbit that is not symmetric is listed with its mirror image. The grid is finite: there
/// may be more orbits. Precondition: the condition passes check_orbits.
/// Throws base::InputError if check_condition does, and base::Stopped if it is asked to stop.
[[nodiscard]] OrbitsOfCondition orbits_of(const Condition& condition, int longest, base::StopRequest stop = {});

/// Throws base::InputError if a condition is random or its excitation is not harmonic.
void check_orbits(const Experiment& experiment);

/// The orbits of all conditions of an experiment, in their order; absent if it was asked to stop before the end.
/// Progress is counted in conditions. Throws as check_orbits. The result depends on the experiment and `longest` alone.
[[nodiscard]] std::optional<std::vector<OrbitsOfCondition>> orbits(const Experiment& experiment, int longest,
                                                                   const RunOptions& options);

}  // namespace rocking
