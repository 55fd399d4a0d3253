// Cost of a period of motion in the lanes of each instruction set of the machine, on one thread. The bits are the same.

#include <string>

#include <benchmark/benchmark.h>

#include "benchmarks/follow.hpp"
#include "rocking/lanes/kernels.hpp"

namespace {

using namespace rocking;
using namespace rocking::benchmarks;

void follow_in_lanes(benchmark::State& state, const Case& c, const lanes::Kernels& kernels) {
  constexpr int at_a_time = 128;
  constexpr double tolerance = 1e-11;
  SideBySide realisations(c, tolerance, kernels);
  for (auto _ : state) benchmark::DoNotOptimize(realisations.finish(at_a_time));
  state.counters["a period"] = benchmark::Counter(static_cast<double>(state.iterations()) * at_a_time * periods,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 64;
  for (const Case& c : usual_cases()) {
    for (const lanes::Kernels& kernels : lanes::available_kernels()) {
      const std::string name = c.name + ": " + std::to_string(kernels.lanes) + " (" + std::string(kernels.name) + ")";
      benchmark::RegisterBenchmark(name.c_str(), [c, &kernels](benchmark::State& state) {
        follow_in_lanes(state, c, kernels);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
