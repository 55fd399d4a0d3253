#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/rare/result.hpp"

namespace rocking::analysis {

/// How a rare event happens when it does: the committor, the probability of the event from each point of the Poincare
/// plane, with the strobe points of a few paths; and the tilt of these paths against time. A panel for each condition,
/// at most six. Empty where there is nothing to draw.
[[nodiscard]] std::vector<Figure> rare_figures(const RareReport& report);

}  // namespace rocking::analysis
