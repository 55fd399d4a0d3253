// Cost of a classification, compared with that of the motion: for each scene the integration of a realisation to its
// horizon, and the classification of the strobe points of forty realisations in turn, of the last 120 and the last 60
// periods. If the exponent is needed, a negative one is given.

#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "evidence/long_run.hpp"

namespace {

using namespace rocking;

struct Case {
  const char* name;
  double amplitude;
  bool slides;   ///< with friction 0.40/0.35
  double sigma;  ///< of friction, or of the restitution where the block does not slide
};

Condition condition_of(const Case& c) {
  Condition condition;
  condition.scene.excitation = Harmonic{.amplitude = c.amplitude, .frequency_ratio = 10.0, .phase = 0.0};
  condition.tolerance = 1e-10;
  condition.scene.initial.tilt = Uniform{.low = 0.05, .high = 0.35};
  if (c.slides) {
    condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = c.sigma;
  } else {
    condition.scene.fluctuation.restitution = c.sigma;
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

void classify_it(benchmark::State& state, const Case& c, std::size_t periods) {
  constexpr std::uint64_t realisations = 40;
  const Condition condition = condition_of(c);
  std::vector<evidence::LongRun> runs;
  for (std::uint64_t i = 0; i < realisations; ++i) {
    evidence::LongRun run(condition, random::Draws(1, i), transient + sampled);
    if (run.periods().size() == transient + sampled) runs.push_back(std::move(run));
  }
  for (auto _ : state) {
    for (const evidence::LongRun& run : runs) {
      const section::ClassifierInput input{
          .periods = std::span(run.periods()).last(periods), .random = true, .resolution = 1e-7};
      benchmark::DoNotOptimize(section::classify(input, [] { return section::ExponentEstimate{-0.2, 0.01}; }));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(runs.size()));
}

void register_all() {
  for (const Case& c :
       {Case{"no sliding, A_h 3", 3.0, false, 0.0}, Case{"no sliding, A_h 4.5", 4.5, false, 0.0},
        Case{"no sliding, A_h 4.5, noise in e", 4.5, false, 0.01}, Case{"sliding, A_h 7", 7.0, true, 0.0},
        Case{"sliding, A_h 7, noise in friction", 7.0, true, 0.03},
        Case{"sliding, A_h 9, noise in friction", 9.0, true, 0.03}}) {
    const std::string name = c.name;
    benchmark::RegisterBenchmark((name + ": integrate").c_str(), integrate_it, c);
    benchmark::RegisterBenchmark((name + ": classify 120").c_str(), classify_it, c, 120);
    benchmark::RegisterBenchmark((name + ": classify 60").c_str(), classify_it, c, 60);
  }
}

}  // namespace

int main(int count, char** arguments) {
  register_all();
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
