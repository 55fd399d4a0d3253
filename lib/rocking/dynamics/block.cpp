#include "rocking/dynamics/block.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/elementary.hpp"

namespace rocking::dynamics {
namespace {

Geometry rectangle(double width, double height, double gravity) {
  const double diagonal = std::sqrt(width * width + height * height);
  const double half_diagonal = 0.5 * diagonal;
  const Edge edge{.shape_angle = base::arc_tangent(width / height),
                  .sine = width / diagonal,
                  .cosine = height / diagonal,
                  .tangent = width / height,
                  .radius = 1.0,
                  .rocking_gain = 1.0,
                  .impact_gain = 1.5,
                  .sideways = 1.0,
                  .half_base = width / diagonal,
                  .tilt_scale = 1.0};
  return {.shape_angle = edge.shape_angle,
          .half_diagonal = half_diagonal,
          .frequency_parameter = std::sqrt(0.75 * gravity / half_diagonal),
          .sine = edge.sine,
          .cosine = edge.cosine,
          .tangent = edge.tangent,
          .inertia = 1.0 / 3.0,
          .over_inertia = 3.0,
          .over_square = 1.0,
          .load = 4.0 / 3.0,
          .form = BlockForm::rectangle,
          .edges = {edge, edge}};
}

/// Whether two numbers agree up to 8 units of the last place.
bool agree(double a, double b) { return std::abs(a - b) <= 8.0 * 0x1p-52 * std::max(std::abs(a), std::abs(b)); }

Edge edge_at(double distance, double other, const MassLayout& mass, const Geometry& block) {
  const double sine = distance / block.half_diagonal;
  const double cosine = mass.centre_height / block.half_diagonal;
  const double pivot_inertia = block.inertia + (sine * sine + cosine * cosine);
  const auto angle = [&mass](double of) { return base::arc_tangent(of / mass.centre_height); };
  return {.shape_angle = angle(distance),
          .sine = sine,
          .cosine = cosine,
          .tangent = distance / mass.centre_height,
          .radius = std::sqrt(sine * sine + cosine * cosine),
          .rocking_gain = block.load / pivot_inertia,
          .impact_gain = 2.0 / pivot_inertia,
          .sideways = other / distance,
          .half_base = 0.5 * (distance + other) / block.half_diagonal,
          .tilt_scale = angle(std::min(distance, other)) / angle(distance)};
}

}  // namespace

namespace {

Geometry free_geometry_of(const Block& block) {
  if (!block.mass) return rectangle(block.width, block.height, block.gravity);
  const auto& [left, right, height, gyration] = *block.mass;
  const double half_base = 0.5 * (left + right);
  const double square = half_base * half_base + height * height;
  if (agree(left, right) && agree(3.0 * gyration * gyration, square)) {
    return rectangle(left + right, 2.0 * height, block.gravity);
  }
  Geometry general{};
  general.form = BlockForm::general;
  general.half_diagonal = std::sqrt(square);
  general.inertia = gyration * gyration / square;
  general.over_inertia = square / (gyration * gyration);
  general.load = 1.0 + general.inertia;
  general.frequency_parameter = std::sqrt(block.gravity / (general.half_diagonal * general.load));
  general.edges = {edge_at(left, right, *block.mass, general), edge_at(right, left, *block.mass, general)};
  const double farther = std::max(left, right);
  general.over_square = square / (farther * farther + height * height);
  const Edge& nearer = general.edges[right < left ? 1 : 0];
  general.shape_angle = nearer.shape_angle;
  general.sine = nearer.sine;
  general.cosine = nearer.cosine;
  general.tangent = nearer.tangent;
  return general;
}

}  // namespace

Geometry geometry_of(const Block& block) {
  Geometry geometry = free_geometry_of(block);
  geometry.open_side = block.open_side;
  return geometry;
}

}  // namespace rocking::dynamics
