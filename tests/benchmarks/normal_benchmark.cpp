// Cost of a normal number: ours, several at a time and one at a time, compared with those of Boost.Random and of the
// standard library, each with its most common engine. Each benchmark fills an array; the last lines are ratios.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/taus88.hpp>

#include "rocking/random/draws.hpp"
#include "rocking/random/normal_kernels.hpp"

namespace {

using namespace rocking::random;

constexpr std::size_t many = 10000;
constexpr std::size_t one_period = 200;  // draws of kinetic friction per excitation period
constexpr std::size_t at_once = 16;      // number that a realisation requests at once
const std::string ours = "rocking, array";
const Draws draws(0x2012, 0);

void in_arrays(benchmark::State& state, std::size_t length, const NormalKernels& kernels) {
  std::vector<double> numbers(length);
  std::uint64_t first = 0;
  for (auto _ : state) {
    draws.standard_normals(Source::check_normal, first, numbers, kernels);
    benchmark::DoNotOptimize(numbers.data());
    first += length;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(length));
}

void in_pairs(benchmark::State& state) {
  std::vector<double> numbers(many);
  std::uint64_t block = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < many; i += 2) {
      const NormalPair pair = draws.standard_normal_pair(Source::check_normal, block++);
      numbers[i] = pair.cosine;
      numbers[i + 1] = pair.sine;
    }
    benchmark::DoNotOptimize(numbers.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(many));
}

template <class Distribution, class Engine>
void by_distribution(benchmark::State& state, Engine engine) {
  std::vector<double> numbers(many);
  Distribution normal;
  for (auto _ : state) {
    for (double& number : numbers) number = normal(engine);
    benchmark::DoNotOptimize(numbers.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(many));
}

void register_all() {
  using Boost = boost::random::normal_distribution<double>;
  using Standard = std::normal_distribution<double>;
  for (const NormalKernels& kernels : available_normal_kernels()) {
    const bool is_best = &kernels == &available_normal_kernels().back();
    const std::string name = is_best ? ours : ours + ", " + std::string(kernels.name);
    benchmark::RegisterBenchmark(name.c_str(), in_arrays, many, kernels);
    benchmark::RegisterBenchmark((name + " of 200").c_str(), in_arrays, one_period, kernels);
    benchmark::RegisterBenchmark((name + " of 16").c_str(), in_arrays, at_once, kernels);
  }
  benchmark::RegisterBenchmark("rocking, pairs", in_pairs);
  benchmark::RegisterBenchmark("boost ziggurat, boost mt19937", by_distribution<Boost, boost::random::mt19937>,
                               boost::random::mt19937(1));
  benchmark::RegisterBenchmark("boost ziggurat, boost mt19937_64", by_distribution<Boost, boost::random::mt19937_64>,
                               boost::random::mt19937_64(1));
  benchmark::RegisterBenchmark("boost ziggurat, boost taus88", by_distribution<Boost, boost::random::taus88>,
                               boost::random::taus88(1));
  benchmark::RegisterBenchmark("boost ziggurat, std mt19937_64", by_distribution<Boost, std::mt19937_64>,
                               std::mt19937_64(1));
  benchmark::RegisterBenchmark("boost ziggurat, our Philox", by_distribution<Boost, PhiloxEngine>,
                               PhiloxEngine(draws, Source::check_normal));
  benchmark::RegisterBenchmark("std, std mt19937", by_distribution<Standard, std::mt19937>, std::mt19937(1));
  benchmark::RegisterBenchmark("std, std mt19937_64", by_distribution<Standard, std::mt19937_64>, std::mt19937_64(1));
}

/// Prints the usual table and keeps the shortest time per number of each benchmark.
class Ratios : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double ns = 1e9 / run.counters.at("items_per_second");
      const auto [entry, is_new] = ns_of_.try_emplace(run.benchmark_name(), ns);
      if (!is_new) entry->second = std::min(entry->second, ns);
    }
  }

  void print() const {
    if (!ns_of_.contains(ours)) return;
    std::printf("\n%-34s %12s %14s\n", "", "ns a number", "times ours");
    for (const auto& [name, ns] : ns_of_) std::printf("%-34s %12.2f %14.2f\n", name.c_str(), ns, ns / ns_of_.at(ours));
  }

 private:
  std::map<std::string, double> ns_of_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 64;
  register_all();
  Ratios ratios;
  benchmark::RunSpecifiedBenchmarks(&ratios);
  ratios.print();
  return 0;
}
