#pragma once

#include <span>

#include "rocking/studies/orbits/corrector.hpp"
#include "rocking/studies/orbits/orbit.hpp"

/// Orbits that graze a guard.
namespace rocking {

/// An orbit of a curve that grazes a guard.
struct Grazing {
  CurvePoint beside;   ///< an orbit next to it, with the changes of contact of the curve
  double share = 0.0;  ///< of the range, at the grazing
  double error = 0.0;  ///< of `share`
};

/// The grazing to which a curve comes, from its points in their order. They may end close to it or at some distance.
///
/// The curve is taken over its margin s from the grazing: the least value of the guard in passing where the motion does
/// not reach it, the rate at which it is reached where it does. Over the parameter a curve that reaches the guard goes
/// like a root, and the multipliers like 1/s; over s it is smooth on both sides, with
///
///     H(z, q) = z,    s(z, q) = s_k
///
/// as its equations, which Newton's method solves at fixed values s_k = s_0 2^k. The polynomial through some successive
/// of these orbits gives that at s = 0: those with the smallest error. `error` is the change of q if the orbit farthest
/// from the grazing is left out, plus the errors of the orbits: Newton's last step and the rounding of the map, times the
/// condition of the equations. The values s_k do not depend on where the curve was left. Of several grazings the nearest
/// to the last point is taken.
///
/// Absent where no guard is near, fewer than four orbits are found, or the error exceeds 1e-9. Throws base::Stopped if
/// it is asked to stop.
[[nodiscard]] std::optional<Grazing> graze(const MapFamily& family, std::span<const CurvePoint> curve,
                                           base::StopRequest stop);

/// A bifurcation on a curve of orbits.
struct LocatedBifurcation {
  BifurcationKind kind = BifurcationKind::fold;
  CurvePoint point;    ///< an orbit there, or next to it
  double share = 0.0;  ///< of the range, at the bifurcation
  double error = 0.0;  ///< of `share`
};

/// What lies on a curve between two of its points.
struct Passage {
  std::vector<CurvePoint> points;  ///< in order, without the first point; with the last one, unless the curve ends
  std::vector<LocatedBifurcation> bifurcations;
  bool is_broken = false;  ///< a bifurcation could not be located: the two points may not be on one curve
  bool is_joined = false;  ///< it ends where it branches off from the family of the mirror image or of half the period
};

/// Whether two orbits of a family have the same changes of contact.
[[nodiscard]] bool is_same_contact(const OrbitFamily& orbits, const PoincareImage& a, const PoincareImage& b);

/// Locates the bifurcations between two neighbouring points of a curve, and its orbits at the `wanted` values of the
/// parameter between them. Each bifurcation is bracketed to 1e-9 in the parameter by a change of sign of its test
/// function, or by a change of the contact sequence. The error of a bracket is its width and the errors of its two orbits.
/// A grazing in it is located by graze().
[[nodiscard]] Passage passage_between(const CurvePoint& a, const CurvePoint& b, const MapFamily& family,
                                      const std::vector<double>& wanted, base::StopRequest stop);

// Steps are lengths in (Theta, Theta', V, share of the range), in which a curve of orbits has a curvature of order 1. From
// a step h Newton's method starts with an error of h^2/2: 2e-4 for the largest step, which it squares to rounding in
// three or four corrections. Five or fewer let the step grow. The first step is a fifth of the largest one, so that a
// curve may be bent more sharply where it starts.
inline constexpr double first_step = 0.004;
inline constexpr double largest_step = 0.02;
inline constexpr int few_newton_steps = 5;
/// The tangents before and after a step make an angle of at most 26 degrees: 0.45/h is then the largest curvature, and
/// another curve, reached by mistake, rarely has such a direction.
inline constexpr double least_cosine = 0.9;

/// Whether the step from `at` to `next` passes the start of the curve.
template <class Point>
[[nodiscard]] bool comes_back(const Point& start, const Point& at, const Point& next) {
  const auto along = plus(next.at, -1.0, at.at);
  const double length = norm(along);
  const double share = dot(plus(start.at, -1.0, at.at), along) / (length * length);
  if (!(share >= 0.0 && share <= 1.0)) return false;
  return norm(plus(plus(at.at, share, along), -1.0, start.at)) < 0.1 * length &&
         dot(start.tangent, next.tangent) > least_cosine;
}

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
