#pragma once

#include "rocking/input/scene_reading.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The keys `block`, `formulation`, `slide_inertia`, `restitution`, `impact_slip_rule`, `excitation`, `friction`,
/// `fluctuation` and `initial`, each value by itself. What values demand of each other: check_relations.
[[nodiscard]] Scene read_scene(ObjectReader& in, const SceneReading& reading);

}  // namespace rocking
