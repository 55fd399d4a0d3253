#pragma once

#include <optional>

#include "rocking/studies/orbits/fold_and_flip.hpp"

/// Orbits that graze a guard, over two parameters.
namespace rocking {

/// Orbits of a family over two parameters, and the guard that is grazed.
struct GrazingFamily {
  CriticalFamily orbits;  ///< its multiplier has no meaning here
  dynamics::Guard guard = dynamics::Guard::tilt;
};

/// An orbit that passes a guard at a very small distance without reaching it.
struct GrazingPoint {
  PlaneUnknowns at{};
  PlaneUnknowns tangent{};  ///< of norm 1
  PlaneUnknowns inward{};   ///< gradient of the distance
  PoincareImage image{};    ///< of the map of the family
  double residual = 0.0;    ///< of the orbit
  double distance = 0.0;    ///< of the guard: least value in passing
  double error = 0.0;       ///< of the first parameter's share: what is left to a distance of 0
};

/// The distance at which an orbit is taken as grazing, in Theta, V, or the friction limit over m R p^2.
inline constexpr double grazing_distance = 1e-11;

/// Smallest distance at which a motion passes a guard; absent if it does not.
[[nodiscard]] std::optional<double> distance_to(dynamics::Guard guard, const PoincareImage& image);

/// The grazing orbit on a hyperplane. It is approached from the side on which the guard is not reached, where map and
/// distance e are smooth: damped Newton's method for
///
///     H(z, p) = z,    e(z, p) = e_k,    normal . (u - through) = 0
///
/// for e_k falling to `grazing_distance`. `start` must be a motion that does not reach the guard. Derivatives of e, and
/// those of H by the parameters, are differences between motions with the same changes of contact. Absent where the
/// residual stays above 1e-13 times the largest entry of M (if above 1). Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<GrazingPoint> graze(const GrazingFamily& family, const PlaneSection& section,
                                                const PlaneUnknowns& start, base::StopRequest stop);

/// A motion near `at` that passes, without reaching it, the guard that `at` reaches at its smallest rate, or that is
/// nearest if it reaches none at a small rate; with this guard.
struct GrazingStart {
  dynamics::Guard guard;
  PlaneUnknowns at{};
};
[[nodiscard]] std::optional<GrazingStart> start_beside(const CriticalFamily& orbits, const PlaneUnknowns& at);

}  // namespace rocking
