#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reproducibility/lanes_crowds.hpp"
#include "rocking/base/error.hpp"
#include "rocking/scene/check_condition.hpp"

/// Every kind of scene that a file can ask for, as changes of one scene, alone and two at a time.
namespace rocking {

struct AskedChange {
  std::string_view name;
  void (*make)(Condition& condition);
};

inline constexpr auto asked_changes = std::to_array<AskedChange>({
    {"no sliding", [](Condition& c) { c.scene.friction = std::nullopt; }},
    {"much sliding",
     [](Condition& c) { c.scene.friction = Friction{.static_coefficient = 0.25, .kinetic_coefficient = 0.22}; }},
    {"friction drawn in time",
     [](Condition& c) { c.scene.fluctuation.static_friction = c.scene.fluctuation.kinetic_friction = 0.02; }},
    {"a coarse grid",
     [](Condition& c) {
       c.scene.fluctuation.kinetic_friction = 0.03;
       c.scene.fluctuation.refreshes_per_period = 7;
     }},
    {"friction of the place",
     [](Condition& c) {
       c.scene.fluctuation.static_friction = c.scene.fluctuation.kinetic_friction = 0.03;
       c.scene.fluctuation.refresh_slip_m = 0.002;
     }},
    {"small cells",
     [](Condition& c) {
       c.scene.fluctuation.kinetic_friction = 0.05;
       c.scene.fluctuation.refresh_slip_m = 2e-4;
     }},
    {"correlated friction",
     [](Condition& c) {
       c.scene.fluctuation.static_friction = c.scene.fluctuation.kinetic_friction = 0.02;
       c.scene.fluctuation.friction_correlation = 0.7;
     }},
    {"other laws",
     [](Condition& c) {
       c.scene.fluctuation.laws = {.static_friction = FluctuationLaw::lognormal,
                                   .kinetic_friction = FluctuationLaw::uniform,
                                   .restitution = FluctuationLaw::uniform,
                                   .amplitude = FluctuationLaw::lognormal};
       c.scene.fluctuation.amplitude = 0.1;
     }},
    {"scatter of restitution", [](Condition& c) { c.scene.fluctuation.restitution = 0.03; }},
    {"scatter of amplitude", [](Condition& c) { c.scene.fluctuation.amplitude = 0.05; }},
    {"jy25", [](Condition& c) { c.scene.restitution = Jy25Restitution{}; }},
    {"a rate ratio", [](Condition& c) { c.scene.restitution = RateRatio{.value = 0.93}; }},
    {"unequal edges", [](Condition& c) { c.scene.restitution = RateRatio{.value = 0.93, .right = 0.9}; }},
    {"as printed",
     [](Condition& c) {
       c.scene.slide_inertia = dynamics::SlideInertia::edge;
       c.scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
     }},
    {"a centre of mass off the middle",
     [](Condition& c) { c.scene.block.mass = GivenCentre{.height = 1.9, .offset = 0.05, .radius_of_gyration = 1.1}; }},
    {"given edges",
     [](Condition& c) {
       c.scene.block.mass = GivenEdges{.edges = {0.5, 0.45}, .centre_height = 2.0, .radius_of_gyration = 1.2};
     }},
    {"parts",
     [](Condition& c) {
       c.scene.block.mass = GivenParts{.parts = {{.height = 2.0}, {.width = 0.8, .height = 2.0, .bottom = 2.0}}};
     }},
    {"vertical motion",
     [](Condition& c) {
       support::harmonic(c.scene).vertical = VerticalHarmonic{.amplitude = 1.0, .frequency_ratio = 20.0};
     }},
    {"a drawn base motion",
     [](Condition& c) {
       support::harmonic(c.scene).amplitude = Uniform{.low = 4.0, .high = 9.0};
       support::harmonic(c.scene).phase = Uniform{.low = 0.0, .high = 6.0};
     }},
    {"an amplitude in g and a frequency in Hz",
     [](Condition& c) {
       support::harmonic(c.scene).physical_amplitude = PhysicalAmplitude{.value = 1.7};
       support::harmonic(c.scene).physical_frequency = PhysicalFrequency{.value = 3.0};
     }},
    {"a pulse of the start",
     [](Condition& c) {
       c.scene.initial.tilt_rate = Uniform{.low = -0.8, .high = 0.8};
       c.scene.initial.slip = 0.3;
       if (c.scene.friction) c.scene.initial.slip_rate = 0.2;
     }},
    {"until classified",
     [](Condition& c) {
       c.horizon.until_classified =
           UntilClassified{.at_most_periods = 250, .held_windows = 2, .watch_windows = 1, .long_run_every = 2};
     }},
    {"until the balance", [](Condition& c) { c.horizon.until = MotionEnd::balance; }},
    {"a coarse tolerance", [](Condition& c) { c.tolerance = 1e-7; }},
    {"a pulse of the base",
     [](Condition& c) {
       c.scene.excitation = Pulse{.shape = dynamics::PulseShape::ricker, .amplitude = 6.0, .frequency_ratio = 7.0};
       c.horizon = {.transient_periods = 0, .sampled_periods = 12};
     }},
    {"a wall",
     [](Condition& c) {
       c.scene.friction = std::nullopt;
       c.scene.block.wall = dynamics::Side::left;
       c.scene.restitution = WallRatio{Uniform{.low = 0.3, .high = 0.7}};
       c.scene.initial.tilt = -0.2;
     }},
    {"a record on a floor of a random building",
     [](Condition& c) {
       GroundMotion motion;
       for (int i = 0; i < 300; ++i) motion.samples.push_back({0.02 * i, i % 40 < 13 ? 0.3 : -0.15, 0.0});
       Recorded recorded = support::recorded_by(std::move(motion), 3.0);
       recorded.building = Building{.frequency_hz = Uniform{.low = 1.0, .high = 2.0}, .height_ratio = 0.7};
       c.scene.excitation = std::move(recorded);
       c.horizon = {.transient_periods = 0, .sampled_periods = 12};
     }},
});

struct AskedScene {
  std::string name;
  Condition condition;
};

/// Those of all changes, and of each two, that a file may have.
inline std::vector<AskedScene> asked_scenes() {
  std::vector<AskedScene> scenes;
  const auto add = [&scenes](const AskedChange& first, const AskedChange& second) {
    Condition condition = from_random_tilt(7.0, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
    condition.horizon = {.transient_periods = 20, .sampled_periods = 48};
    first.make(condition);
    second.make(condition);
    condition.realisations = 1;
    try {
      check_condition(condition);
    } catch (const base::InputError&) {
      return;
    }
    scenes.push_back({std::string(first.name) + ", " + std::string(second.name), condition});
  };
  for (std::size_t i = 0; i < asked_changes.size(); ++i) {
    for (std::size_t j = i; j < asked_changes.size(); ++j) add(asked_changes[i], asked_changes[j]);
  }
  return scenes;
}

}  // namespace rocking
