#pragma once

#include <cstddef>
#include <cstdint>

#include "differential/random_scene.hpp"

namespace rocking::differential {

/// How two accounts of one scene compare.
enum class Outcome : std::uint8_t {
  agreed,  ///< the same to the end
  grown,   ///< the same until small differences have grown too large to tell anything
  split,   ///< another list of events, where ours is another too when the scene is displaced
  disagreed,
};

struct Comparison {
  Outcome outcome = Outcome::agreed;
  std::size_t entries = 0;     ///< events and strobe samples that were compared
  double difference = 0.0;     ///< largest, of times and states
  double share = 0.0;          ///< largest, as a share of what a displacement by `displacement` makes of the same entry
  bool looked_closer = false;  ///< the peer had missed a guard's short dip, and was asked again with smaller steps
};

/// Relative size of the displacements that measure how small differences grow.
inline constexpr double displacement = 1e-9;

/// Differences below this need no explanation: what the peer's tolerance and root finding leave at an event.
inline constexpr double local_error = 1e-10;

/// When a chatter ends, the hops left out would have gone on for 2 peer::Care::shortest_hop/(1 - abs(delta)) or less,
/// and abs(delta) is below 0.995 for H/B <= 12 and e >= -0.5: 4e-9. The rest that follows knows nothing of it.
inline constexpr double chatter_error = 1e-8;

/// Asks ours, the peer and, to see how small differences grow, ours in displaced scenes. A difference is explained
/// while it is below local_error + share_allowed times what the displacements make.
///
/// `asked` is what ours is asked, `peer_asked` what the peer is: the same, but where a test wants to see a difference.
[[nodiscard]] Comparison compare(const Question& asked, const Question& peer_asked, double share_allowed);

}  // namespace rocking::differential
