#include "rocking/random/box_muller.hpp"

#include "rocking/random/box_muller_steps.hpp"

namespace rocking::random {

NormalPair box_muller(const Words& block) {
  const double radius = radius_of(half_of(block, 0));
  const auto [sine, cosine] = sin_cos_of_turn(half_of(block, 1));
  return {radius * cosine, radius * sine};
}

}  // namespace rocking::random
