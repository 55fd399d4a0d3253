#pragma once

#include <string>

#include "analysis/layout.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// Whether no layer of a panel has anything to draw.
[[nodiscard]] bool shows_nothing(const Figure& figure, const Panel& panel);

/// The panel with ranges that gnuplot can draw, whatever its layers hold: both axes in one scale where it is
/// `to_scale`; a range of its own where there are no data for one; the ticks of logarithmic axes.
[[nodiscard]] Panel with_settled_axes(const Figure& figure, const Panel& panel, const Place& place);

/// Frame, ranges, ticks and labels; the words of the x-axis only `with_x`.
[[nodiscard]] std::string axes_text(const Panel& panel, bool with_x);

/// The panel with ticks where round numbers would not do: along a logarithmic axis, and along an axis whose numbers
/// agree in more digits than a label shows. The ticks of such an axis are differences from a number that its label
/// names, `tilt Θ − 60`. A range narrower than rounding is widened. Along a horizontal axis of a panel that is `width`
/// pixels wide there are as few ticks as do not overlap.
[[nodiscard]] Panel with_ticks(const Figure& figure, Panel panel, double width);

}  // namespace rocking::analysis
