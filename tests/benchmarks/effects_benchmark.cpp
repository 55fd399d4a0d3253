// Cost of each effect, in time and in counts of work, and growth of the time with threads, periods and realisations. A
// block of H/B = 4 at Omega_h = 10, tolerance 1e-11, 620 periods, through the whole pipeline of a run (with a store in
// memory).

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include "rocking/ensemble/run.hpp"
#include "support/excitation.hpp"

namespace {

using namespace rocking;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Condition no_sliding() {
  Condition condition;
  condition.tolerance = 1e-11;
  condition.rerun_every = 0;
  rocking::support::harmonic(condition.scene).amplitude = 4.5;
  rocking::support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.initial.tilt = Uniform{.low = 0.05, .high = 0.35};
  condition.realisations = 400;
  return condition;
}

Condition sliding(double static_coefficient, double amplitude) {
  Condition condition = no_sliding();
  condition.scene.friction =
      Friction{.static_coefficient = static_coefficient, .kinetic_coefficient = static_coefficient - 0.05};
  rocking::support::harmonic(condition.scene).amplitude = amplitude;
  return condition;
}

/// The harmonic motion of no_sliding as a ground motion: two hundred samples per period.
Condition recorded(bool has_vertical) {
  Condition condition = no_sliding();
  const auto geometry = rocking::dynamics::geometry_of(mean_block(condition.scene));
  const double frequency = 10.0 * geometry.frequency_parameter;
  GroundMotion motion{.samples = {}, .has_vertical = has_vertical};
  for (int i = 0; i <= 620 * 200; ++i) {
    const double time = i * 2.0 * M_PI / (200.0 * frequency);
    motion.samples.push_back({time, 4.5 * geometry.shape_angle * std::sin(frequency * time),
                              has_vertical ? 0.1 * std::sin(2.0 * frequency * time) : 0.0});
  }
  condition.scene.excitation =
      rocking::support::recorded_by(std::move(motion), rocking::support::mean_frequency_ratio(condition.scene));
  condition.realisations = 20;
  return condition;
}

struct Scene {
  std::string name;
  Condition condition;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all{{"no sliding", no_sliding()},
                         {"sliding possible, absent", sliding(1.35, 4.5)},
                         {"sliding", sliding(0.40, 7.0)},
                         {"fluctuating friction", sliding(0.40, 7.0)},
                         {"fluctuating restitution", no_sliding()},
                         {"fluctuating amplitude", no_sliding()},
                         {"recorded", recorded(false)},
                         {"recorded, with vertical", recorded(true)}};
  all[3].condition.scene.fluctuation.static_friction = all[3].condition.scene.fluctuation.kinetic_friction = 0.03;
  all[4].condition.scene.fluctuation.restitution = 0.01;
  all[5].condition.scene.fluctuation.amplitude = 0.1;
  return all;
}

struct Measured {
  double processor;  ///< [s]
  double wall;       ///< [s]
  ExperimentResult result;
};

Measured measure(const Condition& condition, unsigned threads) {
  Experiment experiment;
  experiment.seed = 0x2012;
  experiment.conditions = {condition};
  RunOptions options;
  options.threads = threads;
  const double processor = processor_seconds();
  const double wall = wall_seconds();
  auto result = run(experiment, options);
  return {processor_seconds() - processor, wall_seconds() - wall, std::move(*result)};
}

double periods_of(const Condition& condition) {
  return static_cast<double>(condition.realisations) *
         (condition.horizon.transient_periods + condition.horizon.sampled_periods);
}

void print_effects() {
  std::printf("%-26s %9s %7s %7s %7s %7s %7s %9s\n", "a period:", "us", "steps", "slip", "roots", "events", "draws",
              "segments");
  for (const auto& [name, condition] : scenes()) {
    double least = 1e300;
    OperationCounts operations;
    for (int repetition = 0; repetition < 3; ++repetition) {
      const Measured measured = measure(condition, 1);
      least = std::min(least, measured.processor);
      operations = measured.result.conditions[0].operations;
    }
    const double periods = periods_of(condition);
    const auto share = [periods](std::uint64_t count) { return static_cast<double>(count) / periods; };
    const auto events = std::accumulate(operations.events.begin(), operations.events.end(), std::uint64_t{0});
    const auto draws = operations.static_friction_draws + operations.kinetic_friction_draws +
                       operations.restitution_draws + operations.amplitude_draws;
    std::printf("%-26s %9.3f %7.2f %7.2f %7.2f %7.2f %7.2f %9.1f\n", name.c_str(), 1e6 * least / periods,
                share(operations.steps), share(operations.slip_steps), share(operations.root_isolations), share(events),
                share(draws), share(operations.ground_motion_segments));
  }
}

void print_scaling() {
  std::printf("\nthreads: wall time of 16000 realisations without sliding\n");
  Condition many = no_sliding();
  many.realisations = 16000;
  double one = 1e300;
  double two = 1e300;
  for (int repetition = 0; repetition < 5;
       ++repetition) {  // alternating, because the speed of the machine may change from one minute to the next
    one = std::min(one, measure(many, 1).wall);
    two = std::min(two, measure(many, 2).wall);
  }
  std::printf("  1: %7.3f s\n  2: %7.3f s, %.2f times one\n", one, two, one / two);
  std::printf("\nperiods and realisations: processor time over both [us], largest memory so far [MiB]\n");
  for (const auto& [realisations, sampled] :
       {std::pair{40, 120}, {400, 120}, {4000, 120}, {40000, 120}, {40, 1120}, {40, 11120}, {40, 111120}}) {
    Condition condition = no_sliding();
    condition.realisations = static_cast<std::uint64_t>(realisations);
    condition.horizon = {.transient_periods = sampled - 20, .sampled_periods = 40};
    const double seconds = measure(condition, 1).processor;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("  %6d realisations of %6d periods: %7.3f %7.1f\n", realisations, sampled + 20,
                1e6 * seconds / periods_of(condition), static_cast<double>(usage.ru_maxrss) / 1024.0);
  }
}

}  // namespace

int main() {
  print_effects();
  print_scaling();
}
