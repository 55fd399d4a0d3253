#pragma once

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Whether the output of `rocking orbits` has branches to draw.
[[nodiscard]] bool has_branches(const Json& output);

/// The figure `branches` of the output of `rocking orbits`: Theta of the orbits at the section against the parameter,
/// stable orbits as solid lines and unstable ones as dashed lines, bifurcations as markers, and the orbits on which the
/// runs of the conditions ended as points. Precondition: has_branches(output).
/// Throws base::InputError if `output` is no such output.
[[nodiscard]] Figure branch_figure(const Json& output);

/// Draws the branches over each panel of a figure of `rocking bifurcation` over the same parameter.
void draw_branches_over(const Json& output, Figure& figure);

}  // namespace rocking::analysis
