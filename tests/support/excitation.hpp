#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "rocking/experiment/experiment.hpp"

/// The kind of excitation that a test's scene is known to have.
namespace rocking::support {

inline experiment::Harmonic& harmonic(experiment::Scene& scene) {
  return std::get<experiment::Harmonic>(scene.excitation);
}
inline const experiment::Harmonic& harmonic(const experiment::Scene& scene) {
  return std::get<experiment::Harmonic>(scene.excitation);
}
inline experiment::Recorded& recorded(experiment::Scene& scene) {
  return std::get<experiment::Recorded>(scene.excitation);
}
inline const experiment::Recorded& recorded(const experiment::Scene& scene) {
  return std::get<experiment::Recorded>(scene.excitation);
}

inline experiment::Harmonic harmonic(experiment::Scene&& scene) {
  return std::get<experiment::Harmonic>(scene.excitation);
}

/// A scene's excitation by a ground motion.
inline experiment::Recorded recorded_by(experiment::GroundMotion motion, double frequency_ratio, double scale = 1.0) {
  return {.ground_motion = std::make_shared<const experiment::GroundMotion>(std::move(motion)),
          .scale = scale,
          .frequency_ratio = frequency_ratio};
}

}  // namespace rocking::support
