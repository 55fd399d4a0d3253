#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rocking/section/classification.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

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
