#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rocking/experiment/result.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::experiment {

/// What arithmetic does to the probabilities, beside what chance does.
enum class ArithmeticNoise : std::uint8_t {
  small,      ///< it is shown to move no probability by more than a fifth of its interval's half-width
  not_small,  ///< it is shown that it may
  undecided,  ///< too few realisations were repeated to tell
};

[[nodiscard]] std::string_view to_string(ArithmeticNoise noise);

/// Realisations that were repeated at another tolerance with the same draws, all conditions together. If a share f of them
/// changes its response mode, no probability moves by more than f.
struct NoiseFloor {
  stats::Proportion flips;   ///< response modes that changed
  stats::Interval interval;  ///< Clopper-Pearson, of the share that changes
  double half_width = 0.0;   ///< half of the widest simultaneous interval in the condition where that is narrowest
  ArithmeticNoise noise = ArithmeticNoise::undecided;
};

/// Absent where nothing was repeated.
[[nodiscard]] std::optional<NoiseFloor> noise_floor(std::span<const ConditionResult> conditions, double confidence);

}  // namespace rocking::experiment
