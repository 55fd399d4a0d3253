#pragma once

#include <optional>
#include <span>

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

}  // namespace rocking
