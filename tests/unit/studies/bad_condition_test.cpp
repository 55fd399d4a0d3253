// Whatever runs a condition that was built in C++ checks it first.

#include <functional>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "rocking/ensemble/run.hpp"
#include "rocking/realisation/continuation.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/bifurcation/study.hpp"
#include "rocking/studies/cost/cost.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/studies/orbits/orbits.hpp"

namespace rocking {
namespace {

/// Two values of friction of a block, at a short horizon.
Experiment experiment_with(const Friction& friction) {
  Experiment experiment;
  for (const double value : {1.0, 2.0}) {
    Condition condition;
    condition.parameters = {{.pointer = "/excitation/amplitude", .value = value}};
    condition.scene.excitation = Harmonic{.amplitude = 2.0, .frequency_ratio = 10.0};
    condition.scene.friction = friction;
    condition.horizon = {.transient_periods = 1, .sampled_periods = 2};
    experiment.conditions.push_back(condition);
  }
  experiment.sweep_sizes = {2};
  return experiment;
}

Store empty_store() { return Store::in_memory({.experiment = "{}", .code = "", .files = "", .shard = std::nullopt}); }

using Entry = std::function<void(const Experiment&)>;

std::map<std::string, Entry> entries() {
  const std::vector<double> tolerances{1e-6, 1e-8, 1e-10};
  return {{"realise", [](const auto& e) { static_cast<void>(realise(e.conditions[0], 0, 0)); }},
          {"trajectory_of", [](const auto& e) { static_cast<void>(trajectory_of(e.conditions[0], 0, 0, {2})); }},
          {"Continuation",
           [](const auto& e) { static_cast<void>(Continuation(random::Draws(0, 0)).run(e.conditions[0])); }},
          {"run", [](const auto& e) { static_cast<void>(run(e, RunOptions{})); }},
          {"verify", [](const auto& e) { static_cast<void>(verify(e, empty_store(), std::nullopt, {})); }},
          {"bifurcation", [](const auto& e) { static_cast<void>(bifurcation(e, 0)); }},
          {"orbits", [](const auto& e) { static_cast<void>(orbits(e, {.longest = 1})); }},
          {"measure_cost",
           [=](const auto& e) { static_cast<void>(measure_cost(e, {.tolerances = tolerances, .sample = 1}, {})); }},
          {"time_cost", [=](const auto& e) {
             const TimingPlan plan{.processor_seconds = [] { return 1.0; }, .seconds_left = [] { return 0.0; }};
             static_cast<void>(time_cost(e, tolerances, plan, {}));
           }}};
}

TEST(EveryEntry, ChecksTheConditionsThatItRuns) {
  const Experiment sound = experiment_with({.static_coefficient = 0.4, .kinetic_coefficient = 0.3});
  const Experiment bad = experiment_with({.static_coefficient = 0.3, .kinetic_coefficient = 0.4});
  for (const auto& [name, entry] : entries()) {
    EXPECT_NO_THROW(entry(sound)) << name;
    try {
      entry(bad);
      ADD_FAILURE() << name << " ran it";
    } catch (const base::InputError& error) {
      EXPECT_EQ(error.problems().front().place, "/friction/static") << name;
    }
  }
}

}  // namespace
}  // namespace rocking
