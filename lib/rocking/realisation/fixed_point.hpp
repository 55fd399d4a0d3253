#pragma once

#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/poincare_map.hpp"

namespace rocking {

/// Largest distance between a fixed point and its image, in Theta, Theta' and V.
inline constexpr double largest_residual = 1e-13;

/// Two points of one orbit differ by at most this: by the residual over the distance of the multipliers from 1, which is
/// taken as 1e-5 at least.
inline constexpr double same_point = 1e-8;

/// A fixed point of the map over a number of periods.
struct FixedPoint {
  section::StrobePoint point;
  PoincareImage image;
  double residual = 0.0;          ///< largest component of image - point
  std::vector<double> residuals;  ///< after each Newton step, from that of the start on
};

/// Newton's method for image(z) = z, with the derivative from the tangent flow. A step that does not reduce the
/// residual is halved, at most six times. Absent if the residual does not fall to largest_residual, or if the motion
/// ends within the periods. Converges quadratically where the map is smooth at the fixed point and has no multiplier 1.
/// Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<FixedPoint> find_fixed_point(const PoincareMap& map, const section::StrobePoint& start,
                                                         int periods, base::StopRequest stop = {});

struct NewtonStep {
  section::StrobePoint step;
  double amplification;  ///< largest coordinate of a step for an image that is off by 1 in each
};

/// Newton's step from a point to a fixed point of the map that takes it to its image: (I - M) step = image - point.
[[nodiscard]] NewtonStep newton_step(const section::StrobePoint& point, const PoincareImage& image);

/// The smallest period of a fixed point of the map over `images.size()` periods: the first divisor after which the motion
/// is back within same_point.
[[nodiscard]] int smallest_period(const section::StrobePoint& start, const std::vector<SectionState>& images);

}  // namespace rocking
