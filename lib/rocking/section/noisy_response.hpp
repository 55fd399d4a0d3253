#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rocking/section/period.hpp"
#include "rocking/section/plane.hpp"
#include "rocking/section/thresholds.hpp"
#include "rocking/section/verdict.hpp"

namespace rocking::section {

/// Whether the exponent is needed to make a verdict of what the strobe points of a noisy response say.
enum class ExponentNeed : std::uint8_t {
  none,           ///< the verdict stands
  to_confirm,     ///< the verdict stands if the exponent is negative
  to_find_chaos,  ///< the verdict, unresolved, stands unless the exponent is positive
};

struct Finding {
  Verdict verdict;
  ExponentNeed need = ExponentNeed::none;
};

/// The points in the plane in which they are compared: (Theta, Theta'), or (V, 0) of a block that never rocked.
[[nodiscard]] std::vector<PlanePoint> plane_points(std::span<const Period> periods);

/// What strobe points and impacts of a response with random draws say by themselves.
///
/// n is the least common period of the spectral lines in the strobe points; the n clouds must then be apart, visited in
/// order, stationary over the window and not remembered too long. Expects at least 48 periods.
[[nodiscard]] Finding find_clouds(std::span<const Period> periods, double resolution,
                                  const Thresholds& thresholds = {});

}  // namespace rocking::section
