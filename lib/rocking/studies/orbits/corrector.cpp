#include "rocking/studies/orbits/corrector.hpp"

#include <algorithm>
#include <utility>

#include "rocking/realisation/fixed_point.hpp"

namespace rocking {
namespace {

// From an error of 1e-2 four corrections reach rounding where the convergence is quadratic. Next to a point at which the
// derivative is singular each correction halves the error: twelve leave 1/4096 of it, or the step is refused.
constexpr int most_corrections = 12;
constexpr double enough = 2e-15;  // a few units in the last place of Theta
/// Rounding of an image is 2^-53 times the largest entry of M, which is below 1e7: a residual below this may stay.
constexpr double may_be_rounding = 1e-9;
/// That of one, over the largest entry of M, with that of the motion behind it.
constexpr double rounding_of_map = 0x1p-52;

/// The coordinates that the image has exactly, since the contact state fixes them, are taken from it.
Unknowns with_fixed_coordinates(Unknowns at, const PoincareImage& image) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_fixed(image, i)) at[i] = 0.0;
  }
  return at;
}

/// Newton's step towards the curve within the plane; absent where there is none.
std::optional<Unknowns> step_to_curve(const MapFamily& family, const Hyperplane& plane, const Unknowns& at,
                                      const PoincareImage& image) {
  const auto by_parameter = family.by_parameter(at, image);
  if (!by_parameter) return std::nullopt;
  const Unknowns away = plus(at, -1.0, plane.through);
  const Unknowns right{at[0] - image.end().tilt, at[1] - image.end().tilt_rate, at[2] - image.end().slip_rate,
                       -dot(plane.normal, away)};
  return solve_bordered({image.derivative, *by_parameter}, plane.normal, right);
}

bool complete(const MapFamily& family, const Hyperplane& plane, CurvePoint& point) {
  const auto by_parameter = family.by_parameter(point.at, point.image);
  if (!by_parameter) return false;
  const MapDerivative derivative{point.image.derivative, *by_parameter};
  point.tangent = direction_of(derivative);
  if (dot(point.tangent, plane.normal) < 0.0) point.tangent = plus({}, -1.0, point.tangent);
  const double rounding = rounding_of_map * amplification(point.image.derivative);
  point.error = condition_of(derivative, point.tangent) * std::max(point.residual, rounding);
  point.flip = flip_determinant(point.image.derivative);
  point.pair = pair_growth(point.image.derivative);
  point.asymmetry = family.asymmetry(point.at, point.image);
  return true;
}

}  // namespace

std::optional<CurvePoint> correct(const MapFamily& family, const Hyperplane& plane, base::StopRequest stop) {
  std::optional<CurvePoint> best;
  Unknowns at = plane.through;
  for (int i = 0; i <= most_corrections; ++i) {
    stop.check();
    auto image = family.image(at);
    if (!image) break;
    const double residual = distance(image->end(), state_of(at));
    if (best && !(residual < best->residual)) {
      if (best->residual < may_be_rounding || residual > 10.0 * best->residual) break;
    }
    const auto step = step_to_curve(family, plane, at, *image);
    const Unknowns next = step ? with_fixed_coordinates(plus(at, 1.0, *step), *image) : at;
    if (!best || residual < best->residual) {
      best = CurvePoint{.at = at, .image = std::move(*image), .residual = residual, .steps = i};
    }
    if (!step || residual < enough) break;
    at = next;
  }
  if (!best || best->image.not_differentiable.any()) return std::nullopt;
  if (!(best->residual <= largest_residual * amplification(best->image.derivative))) return std::nullopt;
  if (!complete(family, plane, *best)) return std::nullopt;
  return best;
}

}  // namespace rocking
