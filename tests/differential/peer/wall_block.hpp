#pragma once

#include <cstdint>

#include "differential/peer/block.hpp"
#include "differential/peer/flow.hpp"
#include "differential/peer/scene.hpp"

namespace rocking::peer {

/// Simulates a block at a wall (lib/docs/model.md, section 12), without friction.
[[nodiscard]] Story story_at_wall(const Scene& scene, std::int64_t periods, double shortest_hop, Flow& flow);

}  // namespace rocking::peer
