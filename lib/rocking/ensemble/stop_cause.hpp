#pragma once

#include <cstdint>
#include <string_view>

namespace rocking {

/// Why a condition has this number of realisations. Reports use the names of the enumerators.
enum class StoppedBecause : std::uint8_t {
  deterministic,          ///< nothing is random: one realisation suffices
  all_realisations_done,  ///< the requested number
  half_width_reached,     ///< all intervals, or that of the requested mode, are as narrow as requested
  at_most_reached,        ///< they are not, but the largest allowed number was reached
};

[[nodiscard]] std::string_view to_string(StoppedBecause cause);

}  // namespace rocking
