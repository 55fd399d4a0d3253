#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/figures/trajectory_file.hpp"

namespace rocking::analysis {

/// `time_history`: Theta and X against time, with the contact state as shading and impacts as markers. The file must
/// have a history.
[[nodiscard]] Figure time_history(const TrajectoryFile& file, const Window& window);

/// `responses`: Theta of several realisations in one panel, as in Fig. 10 of Jeong and Yang (2012). Each file must have
/// a history.
[[nodiscard]] Figure responses(const std::vector<TrajectoryFile>& files, const Window& window);

/// `phase_portrait`: the paths of several realisations in the plane (Theta, Theta'), with their strobe points. Each
/// file must have a history.
[[nodiscard]] Figure phase_portrait(const std::vector<TrajectoryFile>& files, const Window& window);

/// `poincare`: strobe points in the plane (Theta, Theta'), with a style for each file.
[[nodiscard]] Figure poincare(const std::vector<TrajectoryFile>& files, const Window& window);

}  // namespace rocking::analysis
