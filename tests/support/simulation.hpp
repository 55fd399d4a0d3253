#pragma once

#include <cstdint>
#include <numbers>

#include "rocking/dynamics/block_motion.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/integrate/step_length.hpp"
#include "support/event_log.hpp"

namespace rocking::support {

/// The longest steps that the tolerance allows.
struct TaylorSteps {
  double operator()(double last_but_one, double last, int order, double largest) const {
    return integrate::step_length(last_but_one, last, order, largest);
  }
};

/// A block, a base and an initial state, without an experiment. Angles in radians.
struct Stage {
  dynamics::Block block{};
  double frequency = 10.0;
  double phase = 0.0;
  double inertia = 1.0 / 3.0;  ///< J in the equations of slip of a rectangle; other blocks have their own
  dynamics::ImpactSlipRule rule = dynamics::ImpactSlipRule::absolute;
  double tolerance = 1e-13;
  dynamics::State start{};
  std::int64_t periods = 1;

  [[nodiscard]] dynamics::Geometry geometry() const { return dynamics::geometry_of(block); }
  [[nodiscard]] dynamics::Setting setting() const {
    const dynamics::Geometry shape = geometry();
    return {.block = shape,
            .inertia = shape.is_rectangle() ? inertia : shape.inertia,
            .impact_slip_rule = rule,
            .tolerance = tolerance};
  }
  [[nodiscard]] double period_length() const { return 2.0 * std::numbers::pi / frequency; }

  /// A_h psi sin(Omega_h tau + Phi).
  [[nodiscard]] double base_acceleration(double amplitude, double tau) const {
    return amplitude * geometry().shape_angle * base::sin_cos(frequency * tau + phase).sine;
  }

  /// A_h for which the peak of the base acceleration is `peak` [g].
  [[nodiscard]] double amplitude_for(double peak) const { return peak / geometry().shape_angle; }
};

inline const double psi = Stage{}.geometry().shape_angle;         ///< of the default block
inline constexpr double quarter = 0.5 * std::numbers::pi;         ///< phase with the largest push to the right
inline constexpr double three_quarters = 1.5 * std::numbers::pi;  ///< phase with the largest push to the left

/// A simulation of a block with a log of its events. Strobe points are a whole number of periods after tau = 0.
template <dynamics::CoefficientSource Coefficients>
class Simulation {
 public:
  using Motion = dynamics::BlockMotion<Coefficients, TaylorSteps>;

  Simulation(const Stage& stage, const Coefficients& coefficients, const dynamics::Excitation& excitation = {})
      : motion(stage.setting(), dynamics::Clock(stage.frequency, stage.phase), coefficients, stage.start,
               dynamics::Schedule{.first_strobe = {.period = 1, .time = stage.phase / stage.frequency},
                                  .strobes = stage.periods},
               log, excitation) {}
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  Simulation& run() {
    counts = integrate::advance(motion);
    return *this;
  }

  EventLog log;  // before the motion, which reports events from the start
  Motion motion;
  integrate::LoopCounts counts;
};

}  // namespace rocking::support
