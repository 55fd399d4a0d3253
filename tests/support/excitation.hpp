#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "rocking/scene/experiment.hpp"

/// Access to the kind of excitation that the scene of a test has.
namespace rocking::support {

inline Harmonic& harmonic(Scene& scene) { return std::get<Harmonic>(scene.excitation); }
inline const Harmonic& harmonic(const Scene& scene) { return std::get<Harmonic>(scene.excitation); }
inline Recorded& recorded(Scene& scene) { return std::get<Recorded>(scene.excitation); }
inline const Recorded& recorded(const Scene& scene) { return std::get<Recorded>(scene.excitation); }

inline Harmonic harmonic(Scene&& scene) { return std::get<Harmonic>(scene.excitation); }

/// A block under a harmonic excitation.
inline Condition shaken(const Quantity& amplitude, const std::optional<Friction>& friction = {}) {
  Condition condition;
  harmonic(condition.scene) = {.amplitude = amplitude, .frequency_ratio = 10.0};
  condition.scene.friction = friction;
  return condition;
}

/// Omega_h for the mean block.
inline double mean_frequency_ratio(const Scene& scene) {
  return frequency_ratio_for(scene, dynamics::geometry_of(mean_block(scene)));
}

/// A scene's excitation by a ground motion.
inline Recorded recorded_by(GroundMotion motion, double frequency_ratio, double scale = 1.0) {
  return {.ground_motion = std::make_shared<const GroundMotion>(std::move(motion)),
          .scale = scale,
          .frequency_ratio = frequency_ratio};
}

}  // namespace rocking::support
