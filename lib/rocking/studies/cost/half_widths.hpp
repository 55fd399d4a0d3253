#pragma once

#include <cstdint>

namespace rocking {

/// Half-widths of a condition's widest interval at some number of realisations, if modes keep their shares.
struct HalfWidths {
  double mean = 0.0;           ///< over the conditions, of the simultaneous interval
  double widest = 0.0;         ///< of all conditions, of the simultaneous interval
  double widest_wilson = 0.0;  ///< of all conditions, of Wilson's
};

/// Number of realisations that a condition needs for a half-width.
struct RealisationsNeeded {
  std::uint64_t by_shares = 0;  ///< in the condition with the widest interval, if modes keep their shares
  std::uint64_t at_most = 0;    ///< for any shares
};

}  // namespace rocking
