#pragma once

#include <string>
#include <vector>

#include "rocking/api/export.hpp"
#include "rocking/studies/motion/motion.hpp"

namespace rocking {

/// Files with recorded accelerations, and how to read them.
struct GroundMotionRequest {
  std::vector<std::string> files;
  std::string vertical = {};     ///< file with the vertical component of a single file; empty: none
  std::string format = "auto";   ///< `auto`, `columns`, `peer_at2`, `esm_asc`
  std::string units = {};        ///< as `excitation.units`; empty: that of the file, or m/s^2
  double time_step = 0.0;        ///< of columns without times [s]; 0: not given
  bool series = false;           ///< the JSON text also has the motions sample by sample, which draw() needs
  MotionQuestion question = {};  ///< 1 g, damping, periods of the response spectrum, block
};

/// The ground motions with their intensity measures, in the order of the files. Throws base::InputError with the file,
/// line and value of each fault, also for an unknown format or unit, and std::system_error where a file cannot be read.
[[nodiscard]] ROCKING_API std::vector<MeasuredMotion> ground_motions(const GroundMotionRequest& request);

/// The same as JSON text (`rocking.motion/1`).
[[nodiscard]] ROCKING_API std::string motion(const GroundMotionRequest& request);

}  // namespace rocking
