#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/stats/quantile_interval.hpp"

namespace rocking {

/// Levels of the reported quantiles.
inline constexpr std::array quantile_levels{0.05, 0.16, 0.5, 0.84, 0.95};

/// Quantiles of a number over the realisations of a condition, each with its own interval.
struct Quantiles {
  std::uint64_t realisations = 0;  ///< on which they are based
  std::uint64_t beyond = 0;        ///< of these, the ones that count as above every value
  std::vector<stats::QuantileEstimate> levels;
};

/// Quantiles of PeakValues. A realisation that ended before its horizon, overturned or not, counts as above every peak:
/// what is known of it is a lower bound. The final slip is that of the realisations that reached their horizon.
struct PeakQuantiles {
  Quantiles tilt;
  Quantiles tilt_rate;
  struct Slip {
    Quantiles over_half_diagonal;
    std::vector<stats::QuantileEstimate> metres;  ///< of the same realisations
  };
  std::optional<Slip> slip;        ///< absent without friction
  std::optional<Slip> final_slip;  ///< absent without friction
};

}  // namespace rocking
