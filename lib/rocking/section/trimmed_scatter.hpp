#pragma once

#include <cstddef>
#include <numbers>
#include <span>

#include "rocking/section/plane.hpp"

namespace rocking::section {

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
