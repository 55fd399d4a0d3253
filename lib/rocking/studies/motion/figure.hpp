#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/studies/motion/result.hpp"

namespace rocking::analysis {

/// Figures of ground motions: for each motion with a series its acceleration, velocity and displacement
/// (`ground_motion`), and the response spectra of all of them (`response_spectra`). None without series.
[[nodiscard]] std::vector<Figure> motion_figures(const MotionReport& report);

}  // namespace rocking::analysis
