#pragma once

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/object_reader.hpp"

namespace rocking {

/// What is needed to read a scene beside its text.
struct SceneReading {
  DefaultSpelling options;      ///< of the formulation
  DefaultSpelling of_recorded;  ///< strobe under a record
  GroundMotionFiles& files;
};

}  // namespace rocking
