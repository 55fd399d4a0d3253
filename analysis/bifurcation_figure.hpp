#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// `bifurcation`, for each diagram of what `rocking bifurcation` wrote: Theta at the strobe against the parameter, a
/// panel for each way in which steps begin. Few points are drawn as such, with the look of their response mode; many as
/// an image whose cells are shaded by the logarithm of the number of points in them, in which a single point is plain to
/// see. Throws base::InputError where it is no such file.
[[nodiscard]] std::vector<Figure> bifurcation_figures(const report::Json& output);

}  // namespace rocking::analysis
