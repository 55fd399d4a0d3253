#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/orbits/result.hpp"

namespace rocking::analysis {

/// The figure `branches` of periodic orbits: Theta at the section against the parameter, stable orbits as solid lines in
/// the colour of their response mode (the eight most frequent ones) and unstable ones as dashed lines, bifurcations as
/// markers, and the orbits on which the runs of the conditions ended as points. The axis of Theta shows the range of the
/// stable orbits and of these points. Precondition: the study has branches.
[[nodiscard]] Figure branch_figure(const OrbitsReport& report);

/// Draws the branches over each panel of a figure of `rocking bifurcation` over the same parameter. Precondition: the
/// study has branches.
void draw_branches_over(const OrbitStudy& study, Figure& figure);

}  // namespace rocking::analysis
