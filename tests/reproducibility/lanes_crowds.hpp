#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "golden/experiment.hpp"
#include "rocking/scene/experiment.hpp"
#include "support/excitation.hpp"

/// Conditions that meet in lanes: together they have every case that occurs there.
namespace rocking {

inline Condition from_random_tilt(double amplitude, std::optional<Friction> friction = std::nullopt) {
  Condition condition = support::shaken(amplitude, friction);
  condition.scene.initial.tilt = Uniform{.low = -0.4, .high = 0.4};
  condition.horizon = {.transient_periods = 30, .sampled_periods = 30};
  condition.realisations = 12;
  return condition;
}

/// A ground motion of a sine, with `spacing` periods between samples, with or without a vertical part and jumps; one
/// strobe a period.
inline GroundMotion sampled_sine(double spacing, double vertical, bool jumps) {
  Condition reference;
  const double p = dynamics::geometry_of(mean_block(reference.scene)).frequency_parameter;
  const double period = 0.2 * std::numbers::pi;
  GroundMotion motion{.samples = {}, .has_vertical = vertical > 0.0};
  for (int i = 0; i * spacing < 40.0; ++i) {
    const double periods = i * spacing + (i % 3 == 0 ? 0.2 * spacing : 0.0);
    const double angle = 2.0 * std::numbers::pi * periods;
    motion.samples.push_back({periods * period / p, 1.1 * std::sin(angle), vertical * std::sin(1.7 * angle)});
    if (jumps && i % 7 == 0) {
      motion.samples.push_back({periods * period / p, -0.3, 0.2 * vertical});
      if (i % 14 == 0) motion.samples.push_back({periods * period / p, 0.9 * std::cos(angle), -0.2 * vertical});
    }
  }
  return motion;
}

inline Condition recorded(GroundMotion motion, double scale, std::optional<Friction> friction = std::nullopt) {
  Condition condition;
  condition.scene.excitation = support::recorded_by(std::move(motion), 10.0, scale);
  condition.scene.friction = friction;
  condition.scene.initial.tilt = Uniform{.low = -0.4, .high = 0.4};
  condition.horizon = {.transient_periods = 0, .sampled_periods = 42};
  condition.realisations = 6;
  return condition;
}

/// Ground motions with samples closer than the short steps and farther apart, with every contact state.
inline std::vector<Condition> recorded_crowd() {
  std::vector<Condition> conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  const Friction smooth{.static_coefficient = 0.25, .kinetic_coefficient = 0.22};
  for (const double spacing : {1.0 / 250.0, 1.0 / 130.0, 1.0 / 90.0, 0.11}) {
    for (const bool jumps : {false, true}) {
      const GroundMotion motion = sampled_sine(spacing, jumps ? 0.3 : 0.0, jumps);
      conditions.push_back(recorded(motion, 1.0));
      conditions.push_back(recorded(motion, 0.9, rough));
      conditions.push_back(recorded(motion, 1.6, smooth));
      conditions.push_back(recorded(motion, 1.2, rough));
      conditions.back().scene.fluctuation.kinetic_friction = 0.05;
      conditions.back().scene.fluctuation.static_friction = 0.03;
      conditions.push_back(recorded(motion, 1.0, rough));
      conditions.back().scene.fluctuation.amplitude = 0.2;  // its jumps are no knots
      conditions.push_back(recorded(motion, 1.0, rough));
      std::get<Recorded>(conditions.back().scene.excitation).scale = Lognormal{.mean = 1.0, .sigma = 0.3};
      conditions.push_back(recorded(motion, 1.0, rough));
      conditions.back().tolerance = 1e-6;
    }
  }
  return conditions;
}

/// Pulses of every shape, one after another and with harmonic shaking in the lanes beside them, with every kind of
/// contact; their ends among the boundaries of fine and coarse friction grids.
inline std::vector<Condition> pulse_crowd() {
  std::vector<Condition> conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  const Friction smooth{.static_coefficient = 0.25, .kinetic_coefficient = 0.22};
  using enum dynamics::PulseShape;
  for (const Pulse& form : {Pulse{.shape = sine}, Pulse{.shape = cosine, .phase_of_shape = 0.7}, Pulse{.shape = ricker},
                            Pulse{.shape = rectangle}, Pulse{.shape = triangle}, Pulse{.shape = type_c},
                            Pulse{.shape = mavroeidis_papageorgiou, .phase_of_shape = 0.7, .cycles = 1.6}}) {
    for (const double amplitude : {1.3, 4.0, 9.0}) {
      Condition condition = from_random_tilt(1.0);
      Pulse pulse = form;
      pulse.amplitude = amplitude;
      pulse.frequency_ratio = 7.0;
      condition.scene.excitation = pulse;
      condition.horizon = {.transient_periods = 0, .sampled_periods = 12};
      condition.realisations = 6;
      conditions.push_back(condition);
      condition.scene.friction = rough;
      conditions.push_back(condition);
      condition.scene.friction = smooth;
      conditions.push_back(condition);
      condition.scene.fluctuation.amplitude = 0.4;
      for (const int refreshes : {7, 133, 200, 1000}) {
        condition.scene.fluctuation.kinetic_friction = 0.05;
        condition.scene.fluctuation.refreshes_per_period = refreshes;
        conditions.push_back(condition);
      }
      condition.scene.fluctuation.static_friction = 0.03;
      condition.scene.fluctuation.restitution = 0.02;
      conditions.push_back(condition);
    }
  }
  conditions.push_back(from_random_tilt(4.5));
  conditions.push_back(from_random_tilt(7.0, rough));
  return conditions;
}

/// Vertical motion beside the horizontal one, with every kind of contact; other motions in the lanes beside.
inline std::vector<Condition> vertical_crowd() {
  std::vector<Condition> conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  const Friction smooth{.static_coefficient = 0.25, .kinetic_coefficient = 0.22};
  for (const double frequency : {20.0, 10.0, 5.0, 23.7}) {
    for (const auto& friction : {std::optional<Friction>{}, std::optional(rough), std::optional(smooth)}) {
      for (const double amplitude : {1.0, 4.5, 7.0}) {
        Condition condition = from_random_tilt(amplitude, friction);
        support::harmonic(condition.scene).vertical =
            VerticalHarmonic{.amplitude = Uniform{.low = 0.0, .high = 5.0}, .frequency_ratio = frequency, .phase = 1.1};
        conditions.push_back(condition);
        if (!friction) continue;
        condition.scene.fluctuation.kinetic_friction = 0.05;
        condition.scene.fluctuation.refreshes_per_period = amplitude == 7.0 ? 70 : 200;
        conditions.push_back(condition);
      }
    }
  }
  conditions.push_back(from_random_tilt(4.5));
  conditions.push_back(from_random_tilt(7.0, rough));
  return conditions;
}

/// All cases that occur in lanes: rocking with and without friction, slip, coarse and fine grids, amplitudes that jump,
/// chatter and rest, overturning, a slip that ends the model, other blocks and tolerances.
inline std::vector<Condition> crowd() {
  std::vector<Condition> conditions = golden::golden_experiment().conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  conditions.push_back(from_random_tilt(4.5));
  conditions.push_back(from_random_tilt(9.0));
  conditions.push_back(from_random_tilt(7.0, rough));
  conditions.push_back(from_random_tilt(1.0, rough));
  conditions.push_back(from_random_tilt(6.0, Friction{.static_coefficient = 0.25, .kinetic_coefficient = 0.22}));
  for (const int refreshes : {3, 70, 130, 200}) {
    conditions.push_back(from_random_tilt(6.6, rough));
    conditions.back().scene.fluctuation.kinetic_friction = 0.05;
    conditions.back().scene.fluctuation.refreshes_per_period = refreshes;
    support::harmonic(conditions.back().scene).phase = Uniform{.low = 0.0, .high = 6.0};
  }
  for (const double cell : {1e-4, 0.002, 0.3}) {  // friction of the place
    for (const double correlation : {0.0, 1.0}) {
      conditions.push_back(from_random_tilt(6.6, rough));
      Fluctuation& fluctuation = conditions.back().scene.fluctuation;
      fluctuation.kinetic_friction = fluctuation.static_friction = 0.05;
      fluctuation.friction_correlation = correlation;
      fluctuation.refresh_slip_m = cell;
    }
  }
  conditions.push_back(from_random_tilt(6.6, rough));  // friction clamped at 0 and at the static one
  conditions.back().scene.fluctuation.kinetic_friction = 0.3;
  conditions.back().scene.fluctuation.refreshes_per_period = 200;
  conditions.push_back(from_random_tilt(5.0));
  conditions.back().scene.fluctuation.amplitude = 0.5;
  conditions.push_back(from_random_tilt(6.6, rough));
  conditions.back().scene.fluctuation.amplitude = 0.5;
  conditions.back().scene.fluctuation.kinetic_friction = 0.05;
  conditions.push_back(from_random_tilt(8.0, rough));  // its classification needs the exponent
  support::harmonic(conditions.back().scene).phase = Uniform{.low = 0.0, .high = 6.0};
  conditions.back().scene.fluctuation.static_friction = conditions.back().scene.fluctuation.kinetic_friction = 0.02;
  conditions.back().horizon = {.transient_periods = 200, .sampled_periods = 120};
  for (const FluctuationLaw law : {FluctuationLaw::lognormal, FluctuationLaw::uniform}) {  // correlated friction
    conditions.push_back(from_random_tilt(6.6, rough));
    Fluctuation& fluctuation = conditions.back().scene.fluctuation;
    fluctuation = {.static_friction = 0.03, .kinetic_friction = 0.04, .friction_correlation = 0.7};
    fluctuation.laws.static_friction = fluctuation.laws.kinetic_friction = law;
  }
  conditions.push_back(from_random_tilt(1.0));  // every number drawn once
  support::harmonic(conditions.back().scene).amplitude = Lognormal{.mean = 6.0, .sigma = 2.0};
  support::harmonic(conditions.back().scene).frequency_ratio = Uniform{.low = 8.0, .high = 12.0};
  conditions.back().scene.restitution = Triangular{.low = 0.0, .mode = 0.1, .high = 0.3};
  conditions.back().scene.friction =
      Friction{.static_coefficient = Normal{.mean = 0.4, .sigma = 0.05}, .kinetic_ratio = 0.9};
  conditions.push_back(from_random_tilt(4.5));  // impacts that differ between the edges
  conditions.back().scene.restitution = RateRatio{.value = 0.93, .right = 0.89};
  conditions.back().scene.initial.slip = 0.2;
  conditions.push_back(from_random_tilt(7.0, rough));
  conditions.back().scene.restitution = RateRatio{.value = 0.93, .right = 0.89};
  conditions.back().scene.initial.slip = 0.2;
  conditions.push_back(from_random_tilt(0.6));  // chatters to rest, repeatedly
  conditions.push_back(from_random_tilt(4.5));
  conditions.back().scene.fluctuation.restitution = 0.05;
  conditions.push_back(from_random_tilt(30.0));
  support::harmonic(conditions.back().scene).frequency_ratio = 1.0;
  conditions.push_back(from_random_tilt(7.0, Friction{.static_coefficient = 1.6, .kinetic_coefficient = 1.5}));
  conditions.back().scene.block = {.width = 1.0, .height = 0.9, .gravity = 9.81};
  conditions.push_back(from_random_tilt(4.5));
  conditions.back().tolerance = 1e-5;
  return conditions;
}

}  // namespace rocking
