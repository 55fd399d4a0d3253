#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/fold_and_flip.hpp"

/// Curves of folds, period doublings and losses of symmetry over two parameters.
namespace rocking {

/// What a study of curves is asked for. The first parameter is that of the branches.
struct CurveQuestion {
  ConditionPlane conditions;
  std::array<ParameterRange, 2> ranges{};
  double second = 0.0;                  ///< value of the second parameter at which the branches were followed
  std::size_t most_points = 0;          ///< of a curve in each direction
  std::function<void()> on_point = {};  ///< called at each point that is found; empty: nothing
};

inline constexpr std::size_t default_curve_points = 400;

/// Follows each fold, period doubling and loss of symmetry of a study of branches over both parameters, in both
/// directions, unless it is on a curve already.
///
/// The next point is sought along the tangent of the curve of (Theta, Theta', V, p1, p2), and found by Newton's method
/// in the plane normal to it (fold_and_flip.hpp). It is accepted as on a branch (trace.hpp). Where the changes of contact
/// become others, the curve ends. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::vector<BifurcationCurve> bifurcation_curves(const CurveQuestion& question, const BranchStudy& study,
                                                               base::StopRequest stop);

}  // namespace rocking
