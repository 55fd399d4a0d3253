#pragma once

#include <cstddef>
#include <cstdint>

#include "differential/random_scene.hpp"

namespace rocking::differential {

/// Result of the comparison of two accounts of one scene.
enum class Outcome : std::uint8_t {
  agreed,  ///< equal to the end
  grown,   ///< equal until small differences had grown too large for a comparison
  split,   ///< different events, but ours also differ for a displaced scene
  disagreed,
};

struct Comparison {
  Outcome outcome = Outcome::agreed;
  std::size_t entries = 0;     ///< number of events and strobe samples compared
  double difference = 0.0;     ///< largest difference of times and states
  double share = 0.0;          ///< difference over that caused by a displacement by `displacement`, largest
  bool looked_closer = false;  ///< the peer had missed a short dip of a guard and was run again with smaller steps
};

/// Relative size of the displacements that measure the growth of small differences.
inline constexpr double displacement = 1e-9;

/// Differences below this need no explanation: the error of the peer's tolerance and root finding at an event.
inline constexpr double local_error = 1e-10;

/// At the end of a chatter, the neglected hops would have lasted at most 2 peer::Care::shortest_hop/(1 - abs(delta)).
/// abs(delta) is below 0.995 for H/B <= 12 and e >= -0.5: 4e-9. The following rest does not depend on it.
inline constexpr double chatter_error = 1e-8;

/// Runs our program, the peer and, to measure the growth of small differences, our program for displaced scenes. A
/// difference is explained while it is below local_error plus share_allowed times the differences caused by the
/// displacements.
///
/// `asked` is the question to our program, `peer_asked` that to the peer. They differ only if a test requires a
/// difference.
[[nodiscard]] Comparison compare(const Question& asked, const Question& peer_asked, double share_allowed);

}  // namespace rocking::differential
