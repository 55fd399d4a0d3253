// Cost of a classification, compared with that of the motion: for each scene the integration of a realisation to its
// horizon, and the classification of its strobe points. If the exponent is needed, its periods are counted as periods
// of the perturbed pair.

#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "evidence/long_run.hpp"

namespace {

using namespace rocking;

struct Case {
  const char* name;
  double amplitude;
  double sigma;  ///< of friction 0.40/0.35; negative: no sliding, and the absolute value is that of the restitution
};

Condition condition_of(const Case& c) {
  Condition condition;
  condition.scene.excitation = Harmonic{.amplitude = c.amplitude, .frequency_ratio = 10.0, .phase = 0.0};
  condition.tolerance = 1e-10;
  if (c.sigma > 0.0) {
    condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = c.sigma;
  } else {
    condition.scene.fluctuation.restitution = -c.sigma;
  }
  return condition;
}

constexpr int transient = 500;
constexpr int sampled = 120;

void integrate_it(benchmark::State& state, const Case& c) {
  const Condition condition = condition_of(c);
  std::uint64_t realisation = 0;
  for (auto _ : state) {
    evidence::LongRun run(condition, random::Draws(1, realisation++), transient + sampled);
    benchmark::DoNotOptimize(run.periods().data());
  }
}

void classify_it(benchmark::State& state, const Case& c) {
  const Condition condition = condition_of(c);
  const evidence::LongRun run(condition, random::Draws(1, 0), transient + sampled);
  const section::ClassifierInput input{
      .periods = std::span(run.periods()).subspan(transient), .random = is_random(condition.scene), .resolution = 1e-7};
  for (auto _ : state) {
    benchmark::DoNotOptimize(section::classify(input, [] { return section::ExponentEstimate{-0.2, 0.01}; }));
  }
}

void register_all() {
  for (const Case& c :
       {Case{"no sliding, nothing random, (1,1)", 3.0, 0.0}, Case{"no sliding, noise in e, (1,1)", 3.0, -0.01},
        Case{"no sliding, noise in e, (1,3)", 4.5, -0.01}, Case{"sliding, noise in friction, A_h 5", 5.0, 0.03},
        Case{"sliding, noise in friction, A_h 6", 6.0, 0.03}, Case{"sliding, noise in friction, A_h 9", 9.0, 0.03}}) {
    benchmark::RegisterBenchmark((std::string(c.name) + ": integrate").c_str(), integrate_it, c);
    benchmark::RegisterBenchmark((std::string(c.name) + ": classify").c_str(), classify_it, c);
  }
}

}  // namespace

int main(int count, char** arguments) {
  register_all();
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
