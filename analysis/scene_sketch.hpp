#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// The figure `scene`: the block of a canonical experiment to scale, tilted about its left edge, with weight, normal
/// force, friction force and base motion; half diagonal R, shape angle ψ and tilt θ. The tilt is exaggerated so that it
/// is visible.
[[nodiscard]] Figure scene_sketch(const Json& experiment);

/// The scene's numbers in words: `B = 1 m, H = 4 m; ψ = 0.245 rad, R = 2.06 m, p = 1.89 rad/s; A_h = 4.2, Ω_h = 10;
/// ...`.
[[nodiscard]] std::string spoken_scene(const Json& experiment);

}  // namespace rocking::analysis
