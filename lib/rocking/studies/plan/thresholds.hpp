#pragma once

#include <string>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// From which base acceleration a block lifts, and below which friction it slides at rest, in an impact and when it begins to
/// rock: sentences for the mean blocks and the mean friction of all conditions (lib/docs/model.md, sections 3 and 4).
[[nodiscard]] std::string thresholds_text(const Experiment& experiment);

}  // namespace rocking
