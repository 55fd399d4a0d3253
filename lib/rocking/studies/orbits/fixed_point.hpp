#pragma once

#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/poincare_map.hpp"

namespace rocking {

/// Largest distance between a fixed point and its image, in Theta, Theta' and V.
inline constexpr double largest_residual = 1e-13;

/// A fixed point of the map over a number of periods.
struct FixedPoint {
  section::StrobePoint point;
  PoincareImage image;
  double residual = 0.0;          ///< largest component of image - point
  std::vector<double> residuals;  ///< after each Newton step, from that of the start on
};

/// Largest difference in Theta, Theta' or V.
[[nodiscard]] double distance(const section::StrobePoint& a, const section::StrobePoint& b);

/// Newton's method for image(z) = z, with the derivative from the tangent flow. A step that does not reduce the
/// residual is halved, at most six times. Absent if the residual does not fall to largest_residual, or if the motion
/// ends within the periods. Converges quadratically where the map is smooth at the fixed point and has no multiplier 1.
/// Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<FixedPoint> find_fixed_point(const PoincareMap& map, const section::StrobePoint& start,
                                                         int periods, base::StopRequest stop = {});

}  // namespace rocking
