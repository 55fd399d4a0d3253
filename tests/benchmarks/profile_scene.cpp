// Runs one scene through the whole pipeline, to be looked at by callgrind (tests/benchmarks/profile): profile_scene NAME.
// Prints the number of excitation periods that it ran.

#include <cstdint>
#include <cstdio>
#include <cstring>

#include "rocking/experiment/realisation_crew.hpp"
#include "rocking/experiment/store.hpp"
#include "support/excitation.hpp"

namespace {

using namespace rocking;
using experiment::RealisationCrew;

constexpr std::uint64_t realisations = 40;

/// The scenes of integrators_benchmark.cpp, from rest.
experiment::Condition condition_of(const char* name) {
  const bool slides = std::strcmp(name, "no_sliding") != 0;
  experiment::Condition condition;
  condition.tolerance = 1e-11;
  support::harmonic(condition.scene).amplitude = slides ? 7.0 : 4.5;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  if (slides) condition.scene.friction = experiment::Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  if (std::strcmp(name, "fluctuating_friction") == 0) {
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
  }
  return condition;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 64;
  const experiment::Condition condition = condition_of(arguments[1]);
  auto store = experiment::Store::in_memory({});
  std::size_t periods = 0;
  RealisationCrew crew(0x2012, lanes::available_kernels().back());
  for (std::uint64_t next = 0; next < realisations || !crew.is_idle();) {
    for (; next < realisations && crew.wants_more(); ++next) crew.start({&condition, next}, next);
    for (const auto& [number, record] : crew.work()) {
      store.add({.condition = 0, .realisation = number}, experiment::summarise(record, number));
      periods += record.strobe.size();
    }
  }
  store.commit();
  std::printf("%zu\n", periods);
  return 0;
}
