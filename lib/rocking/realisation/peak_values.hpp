#pragma once

#include <algorithm>
#include <cmath>

#include "rocking/dynamics/block.hpp"

namespace rocking {

/// The largest values that a realisation reached, also between strobe points, until it ended, and its slip at the end.
/// Theta and tau are normalised by the realisation's own block.
///
/// Of a realisation that ended before its horizon the peaks are lower bounds: the block went on to fall, or the model
/// had no answer. An overturned one has peak_tilt = (pi/2)/psi, the tilt at which it counts as overturned.
struct PeakValues {
  double tilt = 0.0;          ///< largest abs(Theta) [-]
  double tilt_rate = 0.0;     ///< largest abs(Theta') [-]
  double slip = 0.0;          ///< largest abs(X), over R [-]
  double slip_m = 0.0;        ///< the same [m]
  double final_slip = 0.0;    ///< X at the end, > 0 to the right, over R [-]
  double final_slip_m = 0.0;  ///< the same [m]
};

/// The peaks of a motion (dynamics::BlockMotion) of this block that has ended.
template <class Motion>
[[nodiscard]] PeakValues peaks_of(const Motion& motion, const dynamics::Geometry& block) {
  const double final_slip = motion.final_slip();
  const double slip = std::max(motion.peaks().slip, std::abs(final_slip));
  return {.tilt = motion.peaks().tilt / block.shape_angle,
          .tilt_rate = motion.peaks().tilt_rate / block.shape_angle,
          .slip = slip,
          .slip_m = slip * block.half_diagonal,
          .final_slip = final_slip,
          .final_slip_m = final_slip * block.half_diagonal};
}

}  // namespace rocking
