#pragma once

#include <span>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/corrector.hpp"

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
class PassageSearch {
 public:
  PassageSearch(const MapFamily& family, const std::vector<double>& wanted, base::StopRequest stop)
      : family_(&family), wanted_(&wanted), stop_(stop) {}

  [[nodiscard]] Passage between(const CurvePoint& a, const CurvePoint& b) const;

 private:
  struct Pair {
    CurvePoint before, after;
  };

  void pass(const CurvePoint& a, const CurvePoint& b, int depth, Passage& passage) const;
  void pass_smoothly(const CurvePoint& a, const CurvePoint& b, Passage& passage) const;
  void add_wanted(const CurvePoint& a, const CurvePoint& b, std::vector<CurvePoint>& points) const;
  [[nodiscard]] Pair change_of_contact(const CurvePoint& a, const CurvePoint& b) const;
  [[nodiscard]] std::optional<LocatedBifurcation> located(const CurvePoint& a, const Pair& pair,
                                                          const CurvePoint& b) const;
  template <class Test>
  [[nodiscard]] std::optional<LocatedBifurcation> locate(const CurvePoint& a, const CurvePoint& b, BifurcationKind kind,
                                                         Test&& test, Passage& passage) const;
  [[nodiscard]] std::optional<CurvePoint> at_share(const CurvePoint& a, const CurvePoint& b, double share) const;
  [[nodiscard]] double width(const CurvePoint& a, const CurvePoint& b) const;
  [[nodiscard]] bool is_near(const CurvePoint& a, const CurvePoint& b, double most_apart) const;

  const MapFamily* family_;
  const std::vector<double>* wanted_;
  base::StopRequest stop_;
};

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
