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

}  // namespace rocking::analysis
