#pragma once

#include <cstdint>
#include <optional>

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
  DrawnShaking shaking;
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

/// Excitations of realisations, one after another. Those with equal blocks share the knots of a ground motion.
class SharedExcitation {
 public:
  /// As excitation_of.
  [[nodiscard]] const dynamics::Excitation& of(const Scene& scene, const Beginning& beginning) {
    const double p = beginning.setting.block.frequency_parameter;
    const double psi = beginning.setting.block.shape_angle;
    const double frequency = beginning.clock.frequency();
    const double start = beginning.clock.start();
    const DrawnShaking& drawn = beginning.shaking;
    const bool is_known = last_ && last_->asked == scene.excitation && last_->frequency_parameter == p &&
                          last_->shape_angle == psi && last_->frequency == frequency && last_->start == start &&
                          last_->drawn.vertical == drawn.vertical && last_->drawn.building == drawn.building;
    if (!is_known) {
      last_ = Last{scene.excitation, p, psi, frequency, start, drawn, excitation_of(scene, beginning)};
    } else if (last_->drawn.size != drawn.size) {
      last_->drawn.size = drawn.size;
      last_->excitation = with_size(last_->excitation, drawn.size);
    }
    return last_->excitation;
  }

 private:
  struct Last {
    Excitation asked;
    double frequency_parameter;  ///< p
    double shape_angle;          ///< psi, the unit of the corners of a pulse
    double frequency;            ///< of the clock [-]
    double start;                ///< of the clock, tau
    DrawnShaking drawn;
    dynamics::Excitation excitation;
  };

  /// The same shaking with another size; kinds that hold none stay as they are.
  static dynamics::Excitation with_size(const dynamics::Excitation& excitation, double size) {
    return excitation.visit([size](const auto& kind) -> dynamics::Excitation {
      if constexpr (requires { kind.scaled(size); }) {
        return kind.scaled(size);
      } else {
        return kind;
      }
    });
  }

  std::optional<Last> last_;
};

}  // namespace rocking
