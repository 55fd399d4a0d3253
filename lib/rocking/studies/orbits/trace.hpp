#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/passage.hpp"

namespace rocking {

/// A curve of orbits from a start on in one direction.
struct TracedCurve {
  std::vector<CurvePoint> points;  ///< without the start
  std::vector<LocatedBifurcation> bifurcations;
  BranchEnd end = BranchEnd::range;
};

/// What limits the tracing of a curve.
struct TraceLimits {
  std::vector<double> wanted;  ///< values of q at which the curve has a point
  std::size_t most_points = 0;
  /// Whether an orbit at a wanted value is on a branch that is listed: the curve ends there. Empty: never.
  std::function<bool(const CurvePoint&)> is_known = {};
  std::function<void()> on_point = {};  ///< called at each point of the curve; empty: nothing
};

/// Follows a curve of orbits by pseudo-arclength, from `start` in the direction of its tangent, within 0 <= q <= 1.
///
/// The next point is sought along the tangent and found by Newton's method in the plane normal to it. It is accepted if
/// it is within half a step of where it was sought, and the tangent has turned by less than 26 degrees; behind a change
/// of contact the tangent may have jumped. Else the step is halved, down to 1e-10; after 40 successive steps below 1e-5
/// the curve ends, too. Where that is at a grazing or a change of contact that can be located, this is its end, else it
/// ends at its last point. Steps are at most 0.02 in Theta, Theta', V and the share q of the range. Throws
/// base::Stopped if it is asked to stop.
[[nodiscard]] TracedCurve trace_curve(const MapFamily& family, const CurvePoint& start, const TraceLimits& limits,
                                      base::StopRequest stop);

}  // namespace rocking
