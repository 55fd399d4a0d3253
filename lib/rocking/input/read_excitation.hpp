#pragma once

#include "rocking/dynamics/block.hpp"
#include "rocking/input/scene_reading.hpp"
#include "rocking/scene/excitation.hpp"

namespace rocking {

/// The key `excitation`. Opens a file only for a recorded one.
[[nodiscard]] Excitation read_excitation(ObjectReader& in, const dynamics::Block& block, const SceneReading& reading);

}  // namespace rocking
