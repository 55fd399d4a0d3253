#pragma once

#include <optional>
#include <string>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// The figure `scene`: the mean block of the first condition to scale, tilted about its left edge, with weight, normal
/// force, friction force and base motion; half diagonal R, shape angle ψ and tilt θ. The tilt is exaggerated so that it
/// is visible.
[[nodiscard]] Figure scene_sketch(const Report& report);

/// The numbers of a canonical experiment in words: `B = 1 m, H = 4 m; ψ = 0.245 rad, R = 2.06 m, p = 1.89 rad/s; A_h
/// 4.2 = 1.03 g, Ω_h 10 = 3.01 Hz; ...`.
[[nodiscard]] std::string scene_in_words(const Json& experiment, const std::optional<Shaking>& shaking);

}  // namespace rocking::analysis
