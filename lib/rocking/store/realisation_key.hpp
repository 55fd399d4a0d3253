#pragma once

#include <cstdint>

namespace rocking {

/// Identifies one realisation of one condition; both numbers count from 0.
struct RealisationKey {
  std::uint64_t condition = 0;
  std::uint64_t realisation = 0;

  friend auto operator<=>(const RealisationKey&, const RealisationKey&) = default;
};

}  // namespace rocking
