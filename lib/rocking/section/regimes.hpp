#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rocking/section/period.hpp"
#include "rocking/section/thresholds.hpp"
#include "rocking/section/verdict.hpp"

namespace rocking::section {

/// What the parts of a window say that is not one response as a whole.
struct ChangeOfMind {
  /// The response of tiny clouds that the window ends with, if it held for at least `least_held` of it and began within it.
  /// Stands if the exponent is negative.
  std::optional<Verdict> last_regime;
  /// Where there is none: `changed_regime`, `phase_jump` or `interrupted`; absent if the parts say no more than the whole.
  std::optional<Reason> reason;
};

/// Tries the last seven, six, five and four eighths of the window, and then the first.
/// Expects a noisy response that find_clouds could not name, of at least 48 periods.
[[nodiscard]] ChangeOfMind find_regimes(std::span<const Period> periods, double resolution,
                                        const Thresholds& thresholds = {});

}  // namespace rocking::section
