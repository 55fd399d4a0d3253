#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Points split into classes, with the centre of each and the scatter that all share.
struct Clouds {
  std::vector<PlanePoint> centres;      ///< by class: medians, so that a few strays do not move them
  std::vector<PlanePoint> deviations;   ///< by point, in the order of the points: from the centre of its class
  Covariance scatter;                   ///< within the classes, corrected for the centres taken away
};

/// Which class each point is in: `of[k]` < `count`.
struct Classes {
  std::vector<std::uint32_t> of;
  std::size_t count = 1;
};

/// Classes by turn: point k is in class k mod n.
[[nodiscard]] Classes classes_by_phase(std::size_t points, std::size_t n);

/// Classes by turn, each cut into `parts` equal stretches of time.
[[nodiscard]] Classes classes_by_phase_and_time(std::size_t points, std::size_t n, std::size_t parts);

/// By class: the medians of its points.
[[nodiscard]] std::vector<PlanePoint> centres_of(std::span<const PlanePoint> points, const Classes& classes);

/// By point: from the centre of its class.
[[nodiscard]] std::vector<PlanePoint> deviations_of(std::span<const PlanePoint> points, const Classes& classes,
                                                    std::span<const PlanePoint> centres);

/// The clouds of the given classes.
///
/// The scatter is the covariance of the 90 % of deviations that are smallest in its own metric, scaled to be right for a
/// normal law in the plane, plus `resolution`^2 in each coordinate, below which nothing is known.
[[nodiscard]] Clouds gather(std::span<const PlanePoint> points, const Classes& classes, double resolution);

/// What tells n clouds from a divisor of n.
struct Separation {
  std::size_t divisor = 1;  ///< d, a largest proper divisor of n
  double distance = 0.0;    ///< the greatest Mahalanobis distance between centres d turns apart
};

/// For each largest proper divisor n/p, p prime; none for n = 1. Clouds may coincide, as long as they do not all
/// coincide with the one d turns later.
[[nodiscard]] std::vector<Separation> separations(const Clouds& clouds);

/// By point: whether it lies further than `scatters` from the centre of its class and further than `least`, and nearer to
/// the centre of another class, if there is another.
[[nodiscard]] std::vector<bool> strays(std::span<const PlanePoint> points, const Clouds& clouds, double scatters,
                                       double least);

/// Largest correlation of deviations `lag` apart, over lags 1 ... 12 and directions in the plane: 1 - D/2, with D the
/// covariance of the differences in units of the scatter. Also taken with the median of the squared differences, which
/// shows a return that a few jumps interrupt.
[[nodiscard]] double longest_memory(const Clouds& clouds, double resolution);

/// Distance of the farthest centre from the origin, where the block stands upright: how far the motion goes.
[[nodiscard]] double extent_of(const Clouds& clouds);

/// Largest standard deviation in any direction.
[[nodiscard]] double largest_deviation(const Covariance& scatter);

}  // namespace rocking::section
