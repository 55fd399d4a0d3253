#include "rocking/realisation/orbit_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "rocking/base/natural_logarithm.hpp"
#include "rocking/realisation/fixed_point.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {
namespace {

SectionMatrix square(const SectionMatrix& matrix) {
  SectionMatrix product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) product[row][column] += matrix[row][k] * matrix[k][column];
    }
  }
  return product;
}

double largest_entry(const SectionMatrix& matrix) {
  double largest = 0.0;
  for (const auto& row : matrix) {
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  }
  return largest;
}

/// ln of the spectral radius, from M^(2^24): its norm is that power of the radius, but for a factor whose logarithm is
/// divided by 2^24. -infinity where every small change is lost.
double log_of_spectral_radius(SectionMatrix matrix) {
  constexpr int squarings = 24;
  double logarithm = 0.0;
  double share = 1.0;
  for (int i = 0; i <= squarings; ++i) {
    const double size = largest_entry(matrix);
    if (!(size > 0.0)) return -std::numeric_limits<double>::infinity();
    logarithm += share * base::natural_logarithm(size);
    for (auto& row : matrix) {
      for (double& entry : row) entry /= size;
    }
    matrix = square(matrix);
    share *= 0.5;
  }
  return logarithm;
}

constexpr int most_near_steps = 8;
/// A start that is so far from an orbit is not near it; in Theta, Theta', V.
constexpr double farthest = 0.5;
/// The error behind a step of Newton's method is taken as `curvature` times its square, times the amplification of the step.
/// The point is near enough when that is a twentieth of the distance from the start, which says how the motion approaches
/// the orbit; and when the step is a twentieth of the rate of decay, which changes by about as much along it.
constexpr double curvature = 3.0;
constexpr double accuracy = 0.05;
/// Two points found for one start are those of one orbit if they differ by less than this share of the distance to it.
constexpr double same_orbit = 0.2;
/// A motion that misses the orbit by so many distances of the start after a divisor of its period may have that period, and
/// nearer than the second number it cannot be told from one that has.
constexpr double possible_miss = 1e3;
constexpr double doubtful_miss = 10.0;

/// -ln of the largest multiplier, per period.
double decay_of(const PoincareImage& image) {
  return -log_of_spectral_radius(image.derivative) / static_cast<double>(image.states.size());
}

section::NearbyOrbit orbit_of(const OrbitSearch::Found& found) {
  const PoincareImage& image = found.image;
  section::NearbyOrbit orbit{.points = {found.point},
                             .impacts = image.impacts,
                             .moved = image.moved,
                             .decay = decay_of(image),
                             .derivative = image.derivative};
  for (std::size_t k = 0; k + 1 < image.states.size(); ++k) orbit.points.push_back(image.states[k].point);
  return orbit;
}

/// How far a motion is from the orbit after a divisor of its period, in distances of the start of the search from it.
double miss_after(const PoincareImage& image, const OrbitSearch::Found& found, const section::StrobePoint& near,
                  int periods) {
  const section::StrobePoint& after = image.states[static_cast<std::size_t>(periods) - 1].point;
  return distance(after, found.point) / (distance(found.point, near) + same_point);
}

bool is_same_orbit(const std::optional<OrbitSearch::Found>& shorter, const OrbitSearch::Found& found,
                   const section::StrobePoint& near) {
  return shorter && distance(shorter->point, found.point) <= same_orbit * distance(found.point, near) + same_point;
}

/// The condition of one realisation in which nothing is random along the way.
Condition without_fluctuation(Condition condition, const random::Draws& draws) {
  condition.scene = start_of(condition.scene, draws).scene;
  condition.scene.fluctuation = {};
  return condition;
}

}  // namespace

OrbitSearch::OrbitSearch(const Condition& condition, const random::Draws& draws) {
  if (periods_of_base(condition.scene) != 1) return;
  map_.emplace(without_fluctuation(condition, draws), PoincareMap::Detail::states_and_derivative);
}

std::optional<section::NearbyOrbit> OrbitSearch::find(const section::StrobePoint& near, int periods) const {
  auto found = newton_from(near, periods);
  if (!found) return std::nullopt;
  for (int divisor = 1; divisor < periods; ++divisor) {
    if (periods % divisor != 0) continue;
    const double miss = miss_after(found->image, *found, near, divisor);
    if (miss > possible_miss) continue;
    auto shorter = newton_from(near, divisor);
    if (is_same_orbit(shorter, *found, near)) {
      found = std::move(shorter);
      break;
    }
    if (miss <= doubtful_miss) return std::nullopt;
  }
  return of_smallest_period(*found, near);
}

/// An impact at the strobe may lie between the point and the last one before it, whose image is then far away after a divisor
/// of the period.
std::optional<section::NearbyOrbit> OrbitSearch::of_smallest_period(const Found& found,
                                                                    const section::StrobePoint& near) const {
  const auto periods = static_cast<int>(found.image.states.size());
  const auto image = periods > 1 ? map_->image(found.point, periods) : std::nullopt;
  for (int divisor = 1; image && divisor < periods; ++divisor) {
    if (periods % divisor != 0 || miss_after(*image, found, near, divisor) > doubtful_miss) continue;
    const auto shorter = newton_from(found.point, divisor);
    return is_same_orbit(shorter, found, near) ? std::optional(orbit_of(*shorter)) : std::nullopt;
  }
  return orbit_of(found);
}

std::optional<OrbitSearch::Found> OrbitSearch::newton_from(const section::StrobePoint& near, int periods) const {
  if (!map_) return std::nullopt;
  section::StrobePoint point = near;
  double last_residual = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_near_steps; ++i) {
    auto image = map_->image(point, periods);
    if (!image || image->not_differentiable.any()) return std::nullopt;
    const double residual = distance(image->end(), point);
    if (!(residual <= 0.5 * last_residual)) return std::nullopt;
    last_residual = residual;
    const auto [step, amplification] = newton_step(point, *image);
    point = {point.tilt + step.tilt, point.tilt_rate + step.tilt_rate, point.slip_rate + step.slip_rate};
    const double length = distance(step, {});
    if (!(length < farthest)) return std::nullopt;
    const bool is_near = curvature * amplification * length * length <= accuracy * distance(point, near) + same_point;
    if (is_near && (length <= same_point || length <= accuracy * std::abs(decay_of(*image)))) {
      return Found{.point = point, .image = std::move(*image)};
    }
  }
  return std::nullopt;
}

}  // namespace rocking
