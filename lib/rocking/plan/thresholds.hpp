#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// From which base acceleration a block lifts, and below which friction it slides at rest, in an impact and when it begins to
/// rock: sentences for the mean blocks and the mean friction of all conditions (lib/docs/model.md, sections 3 and 4).
[[nodiscard]] std::string thresholds_text(const Experiment& experiment);

/// The least scale of the motion at which a block leaves full contact by rocking if it cannot slide: abs(alpha) reaches
/// tan(psi) (1 + alpha_v) at some sample. Absent if no scale does.
[[nodiscard]] std::optional<double> least_uplift_scale(const std::vector<dynamics::GroundMotionSample>& samples,
                                                       const dynamics::Geometry& block);

}  // namespace rocking
