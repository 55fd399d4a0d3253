#include "rocking/realisation/fixed_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rocking {
namespace {

// A start is up to 1 from an orbit. A step that is halved at every iteration until it is near enough (1e-2) takes about
// ten, quadratic convergence five more; thirty are twice as many. After six halvings a step is 1/64: a residual that a
// step this short does not reduce is next to a jump of the map, where no orbit follows.
constexpr int most_steps = 30;
constexpr int most_halvings = 6;

/// Three linear equations and their right-hand sides, solved by elimination with row pivots; not finite where they are
/// singular. Own code, because response modes depend on it: the bits of a library differ between machines.
template <std::size_t columns>
void solve(SectionMatrix& matrix, std::array<std::array<double, columns>, 3>& right) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    for (std::size_t row = k + 1; row < 3; ++row) {
      if (std::abs(matrix[row][k]) > std::abs(matrix[pivot][k])) pivot = row;
    }
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == k) continue;
      const double share = matrix[row][k] / matrix[k][k];
      for (std::size_t column = k; column < 3; ++column) matrix[row][column] -= share * matrix[k][column];
      for (std::size_t column = 0; column < columns; ++column) right[row][column] -= share * right[k][column];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (double& entry : right[k]) entry /= matrix[k][k];
  }
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
  const section::StrobePoint step = newton_step(at.point, at.image).step;
  double share = 1.0;
  for (int i = 0; i <= most_halvings; ++i, share *= 0.5) {
    auto next = evaluated(map, moved(at.point, step, share), periods);
    if (next && next->residual < at.residual) return next;
  }
  return std::nullopt;
}

}  // namespace

/// A column of M that the contact state fixes is 0, so that the step takes that coordinate from the image.
NewtonStep newton_step(const section::StrobePoint& point, const PoincareImage& image) {
  SectionMatrix matrix{};
  std::array<std::array<double, 4>, 3> right{};  // the step, and the inverse of the matrix
  const section::StrobePoint& end = image.end();
  const std::array<double, 3> miss{end.tilt - point.tilt, end.tilt_rate - point.tilt_rate,
                                   end.slip_rate - point.slip_rate};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      matrix[row][column] = (row == column ? 1.0 : 0.0) - image.derivative[row][column];
    }
    right[row][0] = miss[row];
    right[row][row + 1] = 1.0;
  }
  solve(matrix, right);
  double amplification = 0.0;
  for (const auto& [step, first, second, third] : right) {
    amplification = std::max(amplification, std::abs(first) + std::abs(second) + std::abs(third));
  }
  return {.step = {.tilt = right[0][0], .tilt_rate = right[1][0], .slip_rate = right[2][0]},
          .amplification = amplification};
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

int smallest_period(const section::StrobePoint& start, const std::vector<SectionState>& images) {
  const auto periods = static_cast<int>(images.size());
  for (int divisor = 1; divisor < periods; ++divisor) {
    if (periods % divisor != 0) continue;
    if (distance(images[static_cast<std::size_t>(divisor) - 1].point, start) < same_point) return divisor;
  }
  return periods;
}

}  // namespace rocking
