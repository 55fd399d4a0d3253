#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// `scene`: the block of a canonical experiment to scale, tilted about its left edge, with what acts on it: weight,
/// normal and friction force, the base's motion; half diagonal R, shape angle ψ and tilt θ. The tilt is drawn large
/// enough to be seen.
[[nodiscard]] Figure scene_sketch(const report::Json& experiment);

/// The scene's numbers in words: `B = 1 m, H = 4 m; ψ = 0.245 rad, R = 2.06 m, p = 1.89 rad/s; A_h = 4.2, Ω_h = 10; ...`.
[[nodiscard]] std::string spoken_scene(const report::Json& experiment);

}  // namespace rocking::analysis
