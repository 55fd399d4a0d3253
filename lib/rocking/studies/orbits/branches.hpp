#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/map_family.hpp"
#include "rocking/studies/orbits/question.hpp"

/// Branches of periodic orbits over a parameter.
namespace rocking {

/// What a study of branches is asked for.
struct BranchQuestion {
  ConditionFamily conditions;
  std::vector<double> values;  ///< of the parameter at the conditions whose orbits are known
  ParameterRange range;
  std::size_t most_points = 0;          ///< of a branch
  std::size_t most_branches = 0;        ///< in all
  std::function<void()> on_point = {};  ///< called at each point that is found; empty: nothing
};

inline constexpr std::size_t default_branch_points = 1000;
inline constexpr std::size_t default_branches = 50;

/// Whether an experiment's parameter is a real number on which the motion depends continuously: lengths and gravity of
/// the block, amplitude and frequency, friction coefficients, restitution.
[[nodiscard]] bool can_be_continued(std::string_view pointer);

/// Follows the orbits of the conditions over the parameter, in the order of conditions and orbits, each that is not on a
/// branch already, in both directions; then the branches that begin at the period doublings and symmetry breakings
/// found, up to section::longest_period. A branch has a point at each value of a condition that it passes. The orbits
/// there are added to `found` if they are new. Throws base::Stopped if it is asked to stop.
[[nodiscard]] BranchStudy branches_of(const BranchQuestion& question, std::vector<OrbitsOfCondition>& found,
                                      base::StopRequest stop);

}  // namespace rocking
