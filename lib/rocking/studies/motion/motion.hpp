#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/scene/excitation.hpp"
#include "rocking/studies/motion/intensity.hpp"
#include "rocking/studies/motion/spectrum.hpp"

namespace rocking {

/// What is asked about ground motions.
struct MotionQuestion {
  double gravity = 9.81;                                ///< [m/s^2]: 1 g
  double damping = 0.05;                                ///< of the response spectrum, in [0, 1)
  std::vector<double> periods;                          ///< of the response spectrum [s]
  std::optional<dynamics::Block> block = std::nullopt;  ///< whose least scale of uplift is wanted
};

/// A ground motion and its intensity measures.
struct MeasuredMotion {
  std::shared_ptr<const GroundMotion> motion;
  std::string sha256;  ///< of its file
  IntensityMeasures measures;
  std::vector<SpectralPoint> spectrum;                ///< one for each period
  std::optional<double> uplift_scale = std::nullopt;  ///< absent: no block, or no scale uplifts it
};

[[nodiscard]] MeasuredMotion measured(std::shared_ptr<const GroundMotion> motion, std::string sha256,
                                      const MotionQuestion& question);

}  // namespace rocking
