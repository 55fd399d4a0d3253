#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "rocking/section/plane.hpp"

namespace rocking::section {

/// Points divided into classes, with the centre of each class and the scatter common to all.
struct Clouds {
  std::vector<PlanePoint> centres;     ///< by class: medians, which a few strays do not move
  std::vector<PlanePoint> deviations;  ///< by point, in the order of the points: from the centre of its class
  Covariance scatter;                  ///< covariance within the classes, corrected for the estimated centres
};

/// Class of each point: `of[k]` < `count`.
struct Classes {
  std::vector<std::uint32_t> of;
  std::size_t count = 1;
};

/// Classes in cyclic order: point k is in class k mod n.
[[nodiscard]] Classes classes_by_phase(std::size_t points, std::size_t n);

/// Classes in cyclic order, each divided into `parts` intervals of equal length in time.
[[nodiscard]] Classes classes_by_phase_and_time(std::size_t points, std::size_t n, std::size_t parts);

/// Medians of the points of each class.
[[nodiscard]] std::vector<PlanePoint> centres_of(std::span<const PlanePoint> points, const Classes& classes);

/// Deviation of each point from the centre of its class.
[[nodiscard]] std::vector<PlanePoint> deviations_of(std::span<const PlanePoint> points, const Classes& classes,
                                                    std::span<const PlanePoint> centres);

/// Computes the clouds of the given classes.
///
/// The scatter is the covariance of the 90 % of deviations that are smallest in its own metric. It is scaled to be
/// unbiased for a normal law in the plane. `resolution`^2 is added in each coordinate, since smaller deviations are not
/// resolved.
[[nodiscard]] Clouds gather(std::span<const PlanePoint> points, const Classes& classes, double resolution);

/// As gather, with centres and deviations that are known.
[[nodiscard]] Clouds clouds_about(std::vector<PlanePoint> centres, std::vector<PlanePoint> deviations,
                                  double resolution);

/// Distance that distinguishes n clouds from a divisor of n.
struct Separation {
  std::size_t divisor = 1;  ///< d = n/p, p prime
  double distance = 0.0;    ///< greatest Mahalanobis distance between centres d periods apart
};

/// Separations for each largest proper divisor n/p, p prime; none for n = 1. Some clouds may coincide with the one d
/// periods later, but not all.
[[nodiscard]] std::vector<Separation> separations(const Clouds& clouds);

/// For each point, whether it is a stray: farther than `scatters` from the centre of its class, farther than `least`,
/// and, if there are other classes, nearer to the centre of another one.
[[nodiscard]] std::vector<bool> strays(std::span<const PlanePoint> points, const Clouds& clouds, double scatters,
                                       double least);

/// Largest correlation of deviations `lag` apart, over lags 1 ... 12 and all directions in the plane: 1 - D/2, where D
/// is the covariance of the differences in units of the scatter. It is also computed from the median of the squared
/// differences, which shows a memory that a few jumps interrupt.
[[nodiscard]] double longest_memory(const Clouds& clouds, double resolution);

/// Whether longest_memory exceeds the limit. Takes a fifth of its time: for most lags a bound shows that it does not.
[[nodiscard]] bool has_longer_memory(const Clouds& clouds, double resolution, double limit);

/// Distance of the farthest centre from the origin (the upright block): the extent of the motion.
[[nodiscard]] double extent_of(const Clouds& clouds);

/// Largest standard deviation over all directions.
[[nodiscard]] double largest_deviation(const Covariance& scatter);

/// For a normal law in the plane the squared distance is exponential with mean 2. The mean below its 90 % point, 2 ln
/// 10, is 2 (1 - 0.1 (1 + ln 10))/0.9 = 2 x 0.744157...; this factor corrects the trimming.
inline constexpr double trimming_correction = 1.0 / 0.74415721411178;

/// The 90 % point of the squared distance for a normal law in the plane.
inline constexpr double expected_limit = 2.0 * std::numbers::ln10;

/// Index, after sorting, of the largest distance that is kept: up to a tenth of the points, which may be strays, are
/// excluded.
[[nodiscard]] std::size_t last_kept(std::size_t count);

/// Covariance about 0 of the deviations without the ones that are largest in the given metric. `memory` has room for two
/// numbers per deviation; the first half of it is then the squared distances. `limit` is the largest one that is kept:
/// before, a guess; then the value.
[[nodiscard]] Covariance trimmed_covariance(std::span<const PlanePoint> deviations, const Covariance& metric,
                                            std::span<double> memory, double& limit);

/// The scatter that is its own metric for trimming, iterated from the sizes along the axes. An iteration leaves less
/// than half of the error in the direction, so that four leave less than a twentieth. This is far below the sampling
/// error of 600 points. `floor` is added to the variances.
[[nodiscard]] Covariance robust_scatter(std::span<const PlanePoint> deviations, double floor);

}  // namespace rocking::section
