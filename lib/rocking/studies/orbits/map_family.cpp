#include "rocking/studies/orbits/map_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rocking/studies/orbits/fixed_point.hpp"

namespace rocking {
namespace {

constexpr double largest_tilt = 3.0;  // no block has pi/2 below psi/2

std::array<double, 3> difference(const section::StrobePoint& a, const section::StrobePoint& b, double over) {
  return {(a.tilt - b.tilt) / over, (a.tilt_rate - b.tilt_rate) / over, (a.slip_rate - b.slip_rate) / over};
}

constexpr std::array difference_steps{1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/// Second difference over the first one, up to which a central difference is taken: its relative error is about the
/// square. Next to a grazing the map goes like a root of the distance, and a long step has a large error.
constexpr double little_bend = 1e-3;

double bend_of(const section::StrobePoint& above, const section::StrobePoint& here, const section::StrobePoint& below) {
  const auto second = [](double a, double b, double c) { return std::abs(a - b + (c - b)); };
  const double bend =
      std::max({second(above.tilt, here.tilt, below.tilt), second(above.tilt_rate, here.tilt_rate, below.tilt_rate),
                second(above.slip_rate, here.slip_rate, below.slip_rate)});
  const double first = distance(above, below);
  return first > 0.0 ? bend / first : 0.0;
}

}  // namespace

std::optional<PoincareMap> MapFamily::map(double q) const {
  if (!std::isfinite(q)) return std::nullopt;
  const auto condition = (*conditions_)(range_.value(q));
  if (!condition) return std::nullopt;
  return PoincareMap(*condition);
}

std::optional<PoincareImage> MapFamily::image(const Unknowns& at) const {
  if (!orbits_.is_symmetric) return full_image(at);
  if (!(std::abs(at[0]) < largest_tilt)) return std::nullopt;
  const auto map = this->map(at[3]);
  return map ? map->mirrored_half(state_of(at), orbits_.period) : std::nullopt;
}

std::optional<PoincareImage> MapFamily::full_image(const Unknowns& at) const {
  if (!(std::abs(at[0]) < largest_tilt) || !std::isfinite(at[1]) || !std::isfinite(at[2])) return std::nullopt;
  const auto map = this->map(at[3]);
  return map ? map->image(state_of(at), orbits_.period) : std::nullopt;
}

std::optional<std::array<double, 3>> MapFamily::by_parameter(const Unknowns& at, const PoincareImage& image) const {
  const auto beside = [&](double step) {
    auto other = this->image({at[0], at[1], at[2], at[3] + step});
    if (other && other->sequence != image.sequence) other.reset();
    return other;
  };
  std::optional<std::array<double, 3>> found;
  double least_bend = std::numeric_limits<double>::infinity();
  for (const double step : difference_steps) {
    const auto above = beside(step);
    const auto below = beside(-step);
    if (above && below) {
      const double bend = bend_of(above->end(), image.end(), below->end());
      if (bend < least_bend) found = difference(above->end(), below->end(), 2.0 * step), least_bend = bend;
      if (bend <= little_bend) return found;
    } else if (!found || least_bend == std::numeric_limits<double>::infinity()) {
      if (above) found = difference(above->end(), image.end(), step);
      if (below) found = difference(image.end(), below->end(), step);
    }
  }
  return found;
}

std::optional<section::StrobePoint> MapFamily::asymmetry(const Unknowns& at, const PoincareImage& image) const {
  if (orbits_.is_symmetric) return std::nullopt;
  section::StrobePoint other;
  if (orbits_.period % 2 == 0) {
    other = image.states[static_cast<std::size_t>(orbits_.period / 2 - 1)].point;
  } else {
    const auto map = this->map(at[3]);
    const auto half = map ? map->mirrored_half(state_of(at), orbits_.period) : std::nullopt;
    if (!half) return std::nullopt;
    other = half->end();
  }
  return section::StrobePoint{.tilt = 0.5 * (at[0] - other.tilt),
                              .tilt_rate = 0.5 * (at[1] - other.tilt_rate),
                              .slip_rate = 0.5 * (at[2] - other.slip_rate)};
}

}  // namespace rocking
