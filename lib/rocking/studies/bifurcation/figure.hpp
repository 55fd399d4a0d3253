#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/bifurcation/result.hpp"

namespace rocking::analysis {

/// The figures `bifurcation` of the output of `rocking bifurcation`, one for each diagram: Theta at the strobe against
/// the parameter, with a panel for each way in which steps begin. A small number of points is drawn as markers in the
/// style of their response mode. A large number is drawn as an image whose cells are shaded by the logarithm of their
/// number of points; a single point is clearly visible.
[[nodiscard]] std::vector<Figure> bifurcation_figures(const BifurcationReport& report);

}  // namespace rocking::analysis
