#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "rocking/dynamics/excitation/recorded.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

/// Random scenes for laws that hold for every motion, under harmonic and recorded excitations.
namespace rocking::property {

enum class Base { harmonic, recorded, recorded_with_vertical };

/// A base acceleration between two knots or at one.
struct Ground {
  double alpha;
  double weight;  ///< 1 + alpha_v
};

struct Scene {
  support::Stage stage;
  support::ScriptedCoefficients coefficients;
  Base base = Base::harmonic;
  std::vector<dynamics::GroundMotionSample> knots{};  ///< their times are tau

  /// Computed independently of the library: linear between the knots, 0 before and after.
  [[nodiscard]] Ground ground(double tau) const {
    const double amplitude = coefficients.amplitude_value;
    if (base == Base::harmonic) return {stage.base_acceleration(amplitude, tau), 1.0};
    const auto next = std::find_if(knots.begin(), knots.end(), [tau](const auto& knot) { return knot.time > tau; });
    if (next == knots.begin() || next == knots.end()) return {0.0, 1.0};
    const auto last = next - 1;
    const double share = (tau - last->time) / (next->time - last->time);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    const double vertical = base == Base::recorded ? 0.0 : between(last->vertical, next->vertical);
    return {amplitude * between(last->horizontal, next->horizontal), 1.0 + vertical};
  }
};

/// A broken line of `periods` excitation periods of the stage, with unevenly spaced knots and occasional jumps. The
/// horizontal motion has the size of A_h = 1, the vertical one is at most 0.8.
inline std::vector<dynamics::GroundMotionSample> random_record(const support::Stage& stage, double periods,
                                                               support::SplitMix& draw) {
  std::vector<dynamics::GroundMotionSample> knots;
  const double size = stage.geometry().shape_angle;
  double time = 0.0;
  while (time < periods * stage.period_length()) {
    knots.push_back({time, draw.uniform(-size, size), draw.uniform(-0.8, 0.8)});
    if (draw.below(5) != 0) time += draw.uniform(0.05, 0.6) * stage.period_length();
  }
  return knots;
}

/// A mass off the middle: a body between two edges, with I from a tenth to six tenths of m R^2.
inline dynamics::MassLayout random_mass(support::SplitMix& draw) {
  const double left = draw.uniform(0.2, 0.8);
  const double right = draw.uniform(0.2, 0.8);
  const double height = std::exp2(draw.uniform(-1.0, 1.0));
  return {.left_edge = left,
          .right_edge = right,
          .centre_height = height,
          .radius_of_gyration = std::sqrt(draw.uniform(0.1, 0.6)) * std::hypot(0.5 * (left + right), height)};
}

/// Calls use(run) with the simulation of the scene at its start.
template <class Use>
void with_simulation(const Scene& scene, Use&& use) {
  using support::ScriptedCoefficients;
  const auto recorded = [&]<bool vertical>() {
    const dynamics::Clock clock(scene.stage.frequency, scene.stage.phase);
    const auto motion = std::make_shared<const dynamics::NormalisedGroundMotion>(scene.knots, 1.0, clock);
    using Excitation = dynamics::RecordedExcitation<vertical>;
    support::Simulation<ScriptedCoefficients> run(scene.stage, scene.coefficients, Excitation(motion, 1.0));
    use(run);
  };
  switch (scene.base) {
    case Base::harmonic: {
      support::Simulation<ScriptedCoefficients> run(scene.stage, scene.coefficients);
      use(run);
      return;
    }
    case Base::recorded: recorded.template operator()<false>(); return;
    case Base::recorded_with_vertical: recorded.template operator()<true>(); return;
  }
}

}  // namespace rocking::property
