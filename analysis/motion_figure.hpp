#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Figures of the output of `rocking motion --series`: for each motion its acceleration, velocity and displacement
/// (`ground_motion`), and the response spectra of all of them (`response_spectra`). None for an output without series.
/// Throws base::InputError where the output is of another form.
[[nodiscard]] std::vector<Figure> motion_figures(const Json& output);

}  // namespace rocking::analysis
