#include "rocking/studies/orbits/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace rocking {
namespace {

// A start is up to 1 from an orbit. A step that is halved at every iteration until it is near enough (1e-2) takes about
// ten, quadratic convergence five more; thirty are twice as many. After six halvings a step is 1/64: a residual that a
// step this short does not reduce is next to a jump of the map, where no orbit follows.
constexpr int most_steps = 30;
constexpr int most_halvings = 6;

Eigen::Vector3d vector_of(const section::StrobePoint& point) { return {point.tilt, point.tilt_rate, point.slip_rate}; }

section::StrobePoint point_of(const Eigen::Vector3d& vector) {
  return {.tilt = vector[0], .tilt_rate = vector[1], .slip_rate = vector[2]};
}

/// (I - M) step = image - point. A column of M that the contact state fixes is 0, so that the step takes that
/// coordinate from the image.
section::StrobePoint newton_step(const FixedPoint& at) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix(row, column) -= at.image.derivative[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
  }
  return point_of(matrix.partialPivLu().solve(vector_of(at.image.end()) - vector_of(at.point)));
}

std::optional<FixedPoint> evaluated(const PoincareMap& map, const section::StrobePoint& point, int periods) {
  const bool is_finite = std::isfinite(point.tilt) && std::isfinite(point.tilt_rate) && std::isfinite(point.slip_rate);
  if (!is_finite || std::abs(point.tilt) > 3.0) return std::nullopt;  // no block has pi/2 below psi/2
  auto image = map.image(point, periods);
  if (!image) return std::nullopt;
  const double residual = distance(image->end(), point);
  return FixedPoint{.point = point, .image = std::move(*image), .residual = residual, .residuals = {}};
}

section::StrobePoint moved(const section::StrobePoint& from, const section::StrobePoint& step, double share) {
  return {.tilt = from.tilt + share * step.tilt,
          .tilt_rate = from.tilt_rate + share * step.tilt_rate,
          .slip_rate = from.slip_rate + share * step.slip_rate};
}

/// The best of the step and its halves that reduces the residual; absent if none does.
std::optional<FixedPoint> improved(const PoincareMap& map, const FixedPoint& at, int periods) {
  const section::StrobePoint step = newton_step(at);
  double share = 1.0;
  for (int i = 0; i <= most_halvings; ++i, share *= 0.5) {
    auto next = evaluated(map, moved(at.point, step, share), periods);
    if (next && next->residual < at.residual) return next;
  }
  return std::nullopt;
}

}  // namespace

double distance(const section::StrobePoint& a, const section::StrobePoint& b) {
  return std::max(
      {std::abs(a.tilt - b.tilt), std::abs(a.tilt_rate - b.tilt_rate), std::abs(a.slip_rate - b.slip_rate)});
}

std::optional<FixedPoint> find_fixed_point(const PoincareMap& map, const section::StrobePoint& start, int periods,
                                           base::StopRequest stop) {
  std::optional<FixedPoint> found = evaluated(map, start, periods);
  if (!found) return std::nullopt;
  std::vector<double> residuals{found->residual};
  for (int i = 0; i < most_steps && found->residual > 0.0; ++i) {
    stop.check();
    auto next = improved(map, *found, periods);
    if (!next) break;
    found = std::move(next);
    residuals.push_back(found->residual);
  }
  if (!(found->residual <= largest_residual)) return std::nullopt;
  found->residuals = std::move(residuals);
  return found;
}

}  // namespace rocking
