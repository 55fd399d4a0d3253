#pragma once

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/motion_files.hpp"
#include "rocking/report/object_reader.hpp"

namespace rocking::report {

/// What is needed to read a scene beside its text.
struct SceneReading {
  DefaultSpelling options;    ///< of the formulation
  DefaultSpelling of_record;  ///< strobe under a record
  MotionFiles& files;
};

/// The keys `block`, `formulation`, `slide_inertia`, `restitution`, `impact_slip_rule`, `excitation`, `friction`,
/// `fluctuation` and `initial`, each value by itself. What values demand of each other: check_scene.
[[nodiscard]] experiment::Scene read_scene(ObjectReader& in, const SceneReading& reading);

/// The key `excitation`. Opens a file only for a recorded one.
[[nodiscard]] experiment::Excitation read_excitation(ObjectReader& in, const dynamics::Block& block,
                                                     const SceneReading& reading);

/// The key `fluctuation`; `scene` already holds the means.
void read_fluctuation(ObjectReader& in, experiment::Scene& scene);

}  // namespace rocking::report
