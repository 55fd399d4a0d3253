#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rocking/stats/interval.hpp"

namespace rocking {

struct ConditionResult;

/// Numerical error of the probabilities, compared with their sampling error.
enum class NumericalError : std::uint8_t {
  small,      ///< shown to change no probability by more than a fifth of the half-width of its interval
  not_small,  ///< shown to be able to
  undecided,  ///< too few realisations were rerun to decide
};

[[nodiscard]] std::string_view to_string(NumericalError noise);

/// Sensitivity to tolerance of all conditions together: realisations that were rerun at a tighter tolerance with common
/// random numbers. If a share f of them changes its response mode, no probability changes by more than f.
struct ToleranceSensitivity {
  stats::Proportion flips;   ///< reruns whose response mode changed
  stats::Interval interval;  ///< Clopper-Pearson interval of the share that changes
  double half_width = 0.0;   ///< half of the widest simultaneous interval of the condition in which this is smallest
  NumericalError noise = NumericalError::undecided;
};

/// Absent if nothing was rerun.
[[nodiscard]] std::optional<ToleranceSensitivity> tolerance_sensitivity(std::span<const ConditionResult> conditions,
                                                                        double confidence);

}  // namespace rocking
