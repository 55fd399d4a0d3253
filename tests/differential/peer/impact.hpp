#pragma once

#include <optional>

#include "differential/peer/mechanics.hpp"

namespace rocking::peer {

/// State and coefficients before the landing.
struct Landing {
  double w;
  double v;
  double restitution;
  std::optional<Friction> friction;  ///< in force; absent: the block cannot slip
  bool signed_rule;
};

struct Rebound {
  double w;
  double v;
  bool slipped;
  bool determined = true;  ///< false: J + Q <= 0, the laws have no solution
};

/// Impact of lib/docs/model.md, sections 4 and 11, with the ratios lambda and delta.
[[nodiscard]] Rebound land(const Body& body, const Landing& before);

}  // namespace rocking::peer
