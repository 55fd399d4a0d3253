#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "analysis/trajectory_file.hpp"

namespace rocking::analysis {

/// `time_history`: Theta and X against time, the state of contact shaded behind them, impacts marked. The file must have a
/// history.
[[nodiscard]] Figure time_history(const TrajectoryFile& file, const Window& window);

/// `responses`: Theta of several realisations over one another, as Jeong and Yang (2012) show repeated responses in their
/// Fig. 10. Each file must have a history.
[[nodiscard]] Figure responses(const std::vector<TrajectoryFile>& files, const Window& window);

/// `poincare`: strobe points in the plane (Theta, Theta'), a look for each file.
[[nodiscard]] Figure poincare(const std::vector<TrajectoryFile>& files, const Window& window);

}  // namespace rocking::analysis
