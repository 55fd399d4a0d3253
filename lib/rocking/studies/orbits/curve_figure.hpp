#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/orbits/result.hpp"

namespace rocking::analysis {

/// The figure `curves` of periodic orbits: the second parameter against the first one on each curve of folds, period
/// doublings and losses of symmetry, with a symbol where a curve ends by grazing or another change of contact.
/// Precondition: the study has curves.
[[nodiscard]] Figure curve_figure(const OrbitsReport& report);

}  // namespace rocking::analysis
