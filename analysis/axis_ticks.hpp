#pragma once

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The panel with ticks where round numbers would not do: along a logarithmic axis, and along an axis whose numbers
/// agree in more digits than a label shows. The ticks of such an axis are differences from a number that its label
/// names, `tilt Θ − 60`. A range narrower than rounding is widened. Along a horizontal axis of a panel that is `width`
/// pixels wide there are as few ticks as do not overlap.
[[nodiscard]] Panel with_ticks(const Figure& figure, Panel panel, double width);

}  // namespace rocking::analysis
