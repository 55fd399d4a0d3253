#pragma once

#include "rocking/ensemble/run.hpp"
#include "rocking/studies/orbits/map_family.hpp"
#include "rocking/studies/orbits/orbit.hpp"
#include "rocking/studies/orbits/question.hpp"

/// Periodic orbits of conditions with harmonic excitation in which nothing is random, stable and unstable ones.
namespace rocking {

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

/// What a study of branches is asked for.
struct BranchQuestion {
  ConditionFamily conditions;
  std::vector<double> values;  ///< of the parameter at the conditions whose orbits are known
  ParameterRange range;
  std::size_t most_points = 0;          ///< of a branch
  std::size_t most_branches = 0;        ///< in all
  std::function<void()> on_point = {};  ///< called at each point that is found; empty: nothing
};

/// Whether the motion depends continuously on a number of an experiment: on those of the block, the base, friction and
/// restitution, but not on a vertical motion, whose frequency must fit the strobe.
[[nodiscard]] bool can_be_continued(std::string_view pointer);

/// Follows the orbits of the conditions over the parameter, in the order of conditions and orbits, each that is not on a
/// branch already, in both directions; then the branches that begin at the period doublings and symmetry breakings
/// found, up to section::longest_period. A branch has a point at each value of a condition that it passes. The orbits
/// there are added to `found` if they are new. Throws base::Stopped if it is asked to stop.
[[nodiscard]] BranchStudy branches_of(const BranchQuestion& question, std::vector<OrbitsOfCondition>& found,
                                      base::StopRequest stop);

}  // namespace rocking
