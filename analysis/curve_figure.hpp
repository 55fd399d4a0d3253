#pragma once

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Whether the output of `rocking orbits` has curves of bifurcations to draw.
[[nodiscard]] bool has_curves(const Json& output);

/// The figure `curves` of the output of `rocking orbits`: the second parameter against the first one on each curve of
/// folds, period doublings and losses of symmetry, with a symbol where a curve ends by grazing or another change of
/// contact. Precondition: has_curves(output). Throws base::InputError if `output` is no such output.
[[nodiscard]] Figure curve_figure(const Json& output);

}  // namespace rocking::analysis
