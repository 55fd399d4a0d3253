#pragma once

#include <cstdint>
#include <variant>

#include "rocking/dynamics/block_motion.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/random/branched_draws.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/realisation/scene_coefficients.hpp"
#include "rocking/scene/experiment.hpp"

/// Connects dynamics and integrator: one seeded run of one condition.
namespace rocking {

/// The longest steps that the tolerance allows.
struct TaylorSteps {
  double operator()(double last_but_one, double last, int order, double largest) const {
    return integrate::step_length(last_but_one, last, order, largest);
  }
};

using Motion = dynamics::BlockMotion<SceneCoefficients, TaylorSteps>;

/// Values that a realisation draws once, at its start.
struct Start {
  Scene scene;  ///< with a number in the place of each law
  dynamics::Block block;
  dynamics::Geometry geometry;  ///< of the block
  double phase;                 ///< Phi in [0, 2 pi) [rad]
  dynamics::State state;
  std::uint64_t draws;  ///< number of draws made for it
  Clamps clamps;        ///< of these draws
};

[[nodiscard]] Start start_of(const Scene& scene, const random::BranchedDraws& draws);

/// Instants of the strobe points. `poincare`: the argument of the excitation is a multiple of 2 pi. `start`: a whole
/// number of periods after tau = 0.
enum class Strobe : std::uint8_t { poincare, start };

/// A realisation at tau = 0, without its base motion.
struct Beginning {
  dynamics::Setting setting;
  dynamics::Clock clock;
  SceneCoefficients coefficients;
  dynamics::State state;
  double excitation_size;  ///< that was drawn: the scale of a ground motion
  dynamics::Schedule schedule;
  std::uint64_t draws;  ///< of the start
  Clamps clamps;        ///< of the start
};

/// Precondition: the condition is valid (check_condition).
[[nodiscard]] Beginning begin_realisation(const Condition& condition, const random::BranchedDraws& draws,
                                          const Start& start, Strobe strobe, std::int64_t periods);

/// The base motion that the scene asks for.
[[nodiscard]] dynamics::Excitation excitation_of(const Scene& scene, const Beginning& beginning);

/// The motion of a block on this base, ready to be advanced.
[[nodiscard]] inline Motion motion_of(const Beginning& beginning, dynamics::Observer& observer,
                                      const dynamics::Excitation& excitation) {
  return {beginning.setting, beginning.clock, beginning.coefficients, beginning.state, beginning.schedule,
          observer,          excitation};
}
[[nodiscard]] inline Motion motion_of(const Scene& scene, const Beginning& beginning, dynamics::Observer& observer) {
  return motion_of(beginning, observer, excitation_of(scene, beginning));
}

}  // namespace rocking
