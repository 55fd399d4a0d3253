#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/section/classification.hpp"
#include "rocking/section/clouds.hpp"
#include "rocking/section/plane.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// Whether the exponent is needed to classify a noisy response.
enum class ExponentNeed : std::uint8_t {
  none,           ///< the classification is final
  to_confirm,     ///< the classification holds if the exponent is negative
  to_find_chaos,  ///< the classification, unresolved, holds unless the exponent is positive
  to_find_orbit,  ///< the same, unless the exponent is negative and the clouds lie about a stable orbit
};

struct Finding {
  Classification classification;
  ExponentNeed need = ExponentNeed::none;
  int periods = 0;                     ///< n: number of clouds; 0 if it is above longest_period
  std::vector<Separation> apart = {};  ///< of the clouds from those of the divisors of n
};

/// The points in the plane in which they are compared: (Theta, Theta'), or (V, 0) for a block that never rocked.
[[nodiscard]] std::vector<PlanePoint> plane_points(std::span<const Period> periods);

/// Classifies a response with random numbers by its strobe points and impacts.
///
/// n is the least common period of the spectral lines of the strobe points. The n clouds must be separate, visited in
/// order and stationary over the window, and deviations must decay fast enough. Needs at least 48 periods.
[[nodiscard]] Finding find_clouds(std::span<const Period> periods, double resolution,
                                  const Thresholds& thresholds = {});

/// Whether clouds are farther apart than noise makes them by chance whose deviations shrink by so much per period (> 0). A
/// motion that returns slowly to an orbit of a divisor of n keeps its phase for a part of the window, and looks like n clouds.
[[nodiscard]] bool are_apart(const Finding& finding, std::size_t periods, double decay, const Thresholds& thresholds);

/// Whether too many points, or those at the end, are not in the cloud that should come next.
[[nodiscard]] bool are_out_of_order(std::span<const PlanePoint> points, const Clouds& clouds,
                                    const Thresholds& thresholds);

/// Classification of a response that changes within the window, from parts of the window.
struct RegimeChange {
  /// The periodic response with tight clouds in the last part of the window, if it began within the window and lasted
  /// for at least `least_held` of it. It holds if the exponent is negative.
  std::optional<Classification> last_regime;
  /// Otherwise `changed_regime`, `phase_jump` or `interrupted`; absent if the parts show no more than the whole window.
  std::optional<Reason> reason;
};

/// Tests the last seven, six, five and four eighths of the window, then the first ones. Needs a noisy response that
/// find_clouds left unresolved, with at least 48 periods.
[[nodiscard]] RegimeChange find_regimes(std::span<const Period> periods, double resolution,
                                        const Thresholds& thresholds = {});

}  // namespace rocking::section
