// Runs one scene through the whole pipeline under callgrind (tests/benchmarks/profile): profile_scene NAME. Prints the
// number of excitation periods that it ran.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/store/store.hpp"
#include "support/excitation.hpp"

namespace {

using namespace rocking;

constexpr std::uint64_t realisations = 40;

/// The harmonic base motion of the condition as a ground motion of two hundred samples a period.
Recorded recording_of(const Condition& condition) {
  const auto block = dynamics::geometry_of(rocking::mean_block(condition.scene));
  const double ratio = mean_of(support::harmonic(condition.scene).frequency_ratio);
  const double peak = mean_of(support::harmonic(condition.scene).amplitude) * block.shape_angle;
  const double frequency = ratio * block.frequency_parameter;
  GroundMotion motion{.samples = {}, .has_vertical = false};
  for (int i = 0; i <= 620 * 200; ++i) {
    const double time = i * 2.0 * M_PI / (200.0 * frequency);
    motion.samples.push_back({time, peak * std::sin(frequency * time), 0.0});
  }
  return support::recorded_by(std::move(motion), ratio);
}

/// The scenes of integrators_benchmark.cpp, from rest, and no_sliding by a recorded excitation.
Condition condition_of(const char* name) {
  const bool is_recorded = std::strcmp(name, "recorded") == 0;
  const bool slides = std::strcmp(name, "no_sliding") != 0 && !is_recorded;
  Condition condition;
  condition.tolerance = 1e-11;
  support::harmonic(condition.scene).amplitude = slides ? 7.0 : 4.5;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  if (slides) condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  if (std::strcmp(name, "fluctuating_friction") == 0) {
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
  }
  if (is_recorded) condition.scene.excitation = recording_of(condition);
  return condition;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 64;
  const Condition condition = condition_of(arguments[1]);
  auto store = Store::in_memory({});
  std::size_t periods = 0;
  RealisationScheduler scheduler(0x2012, lanes::available_kernels().back());
  for (std::uint64_t next = 0; next < realisations || !scheduler.is_idle();) {
    for (; next < realisations && scheduler.wants_more(); ++next) scheduler.start({&condition, next}, next);
    for (const auto& [number, result] : scheduler.work()) {
      store.add({.condition = 0, .realisation = number}, summarise(result, number));
      periods += result.strobe.size();
    }
  }
  store.commit();
  std::printf("%zu\n", periods);
  return 0;
}
