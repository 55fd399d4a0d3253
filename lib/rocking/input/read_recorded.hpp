#pragma once

#include "rocking/dynamics/block.hpp"
#include "rocking/input/scene_reading.hpp"
#include "rocking/scene/excitation.hpp"

namespace rocking {

/// The keys of `excitation` with `"kind": "recorded"`. Its ground motion is null where anything is wrong with it; the
/// problems are reported. Throws std::system_error where a file cannot be read.
[[nodiscard]] Recorded read_recorded(ObjectReader& keys, const dynamics::Block& block, const SceneReading& reading);

}  // namespace rocking
