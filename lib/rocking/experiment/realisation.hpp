#pragma once

#include <cstdint>
#include <memory>

#include "rocking/dynamics/block_motion.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/scene_coefficients.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/random/draws.hpp"

/// Where the dynamics and the integrator meet: one seeded run of one condition.
namespace rocking::experiment {

/// Steps as long as the tolerance allows.
struct TaylorSteps {
  double operator()(double last_but_one, double last, int order, double largest) const {
    return integrate::step_length(last_but_one, last, order, largest);
  }
};

/// A block on a base that moves as `Excitation` says.
template <dynamics::BaseExcitation Excitation>
using Motion = dynamics::BlockMotion<SceneCoefficients, TaylorSteps, Excitation>;

/// What a realisation draws once, at its start.
struct Start {
  double phase;  ///< Phi in [0, 2 pi) [rad]
  dynamics::State state;
  std::uint64_t draws;  ///< how many numbers that took
};

[[nodiscard]] Start start_of(const Scene& scene, const random::Draws& draws);

/// Where strobe points are taken: `poincare` where the excitation's argument is a multiple of 2 pi, `start` a whole number
/// of periods after tau = 0.
enum class Strobe : std::uint8_t { poincare, start };

/// A realisation at tau = 0, but for the kind of its base motion.
struct Beginning {
  dynamics::Setting setting;
  dynamics::Clock clock;
  SceneCoefficients coefficients;
  dynamics::State state;
  dynamics::Schedule schedule;
};

/// Throws base::InputError where a number of the condition is none; see check_condition.
[[nodiscard]] Beginning begin_realisation(const Condition& condition, const random::Draws& draws, const Start& start,
                                          Strobe strobe, std::int64_t periods);

/// Calls use(excitation) with the base motion that the scene asks for.
template <class Use>
decltype(auto) with_excitation(const Scene& scene, const Beginning& beginning, Use&& use) {
  if (scene.excitation.record == nullptr) return use(dynamics::HarmonicExcitation{});
  const auto motion = std::make_shared<const dynamics::RecordedMotion>(
      scene.excitation.record->samples, beginning.setting.block.frequency_parameter, beginning.clock);
  const double scale = scene.excitation.amplitude;
  if (scene.excitation.record->has_vertical) return use(dynamics::RecordedExcitation<true>(motion, scale));
  return use(dynamics::RecordedExcitation<false>(motion, scale));
}

template <class Excitation>
[[nodiscard]] Motion<Excitation> motion_of(const Beginning& beginning, dynamics::Observer& observer,
                                           const Excitation& excitation) {
  return {beginning.setting, beginning.clock, beginning.coefficients, beginning.state, beginning.schedule,
          observer,          excitation};
}

/// Calls use(motion) with the motion that the scene's excitation asks for, ready to be advanced.
template <class Use>
decltype(auto) with_motion(const Scene& scene, const Beginning& beginning, dynamics::Observer& observer, Use&& use) {
  return with_excitation(scene, beginning, [&](const auto& excitation) -> decltype(auto) {
    return use(motion_of(beginning, observer, excitation));
  });
}

}  // namespace rocking::experiment
