#include "rocking/lanes/kernels.hpp"

#include <ctime>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "rocking/dynamics/block_motion.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/lanes/units.hpp"

namespace rocking::lanes {
namespace {

std::vector<Kernels> those_that_run_here() {
  std::vector<Kernels> all;
  const auto add = [&all](std::span<const Kernels> kernels) { all.insert(all.end(), kernels.begin(), kernels.end()); };
  add(one_lane_kernels());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) add(avx2_kernels());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
    add(avx512_kernels());
  }
#endif
  add(neon_kernels());  // part of every such processor
  return all;
}

/// A block with H/B = 4 that rocks and slips for two periods of the base.
class TrialRun final : private dynamics::Observer {
 public:
  explicit TrialRun(double tilt)
      : motion_({.block = block(), .inertia = 1.0 / 3.0, .impact_slip_rule = {}, .tolerance = 1e-10},
                dynamics::Clock(10.0, 0.0),
                {.amplitude_value = 7.0, .restitution_value = 0.0, .static_value = 0.40, .kinetic_value = 0.35},
                {.tilt = tilt * block().shape_angle}, {.first_strobe = {.period = 1, .time = 0.0}, .strobes = 2},
                *this) {}
  TrialRun(const TrialRun&) = delete;
  TrialRun& operator=(const TrialRun&) = delete;

  struct Steps {
    double operator()(double last_but_one, double last, int order, double largest) const {
      return integrate::step_length(last_but_one, last, order, largest);
    }
  };
  [[nodiscard]] auto& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }
  [[nodiscard]] static bool go_on() { return false; }

 private:
  static const dynamics::Geometry& block() {
    static const dynamics::Geometry geometry = dynamics::geometry_of({.width = 1.0, .height = 4.0});
    return geometry;
  }
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State&) override {}

  dynamics::BlockMotion<dynamics::ConstantCoefficients, Steps> motion_;
  integrate::LoopCounts counts_;
};

double thread_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time for a run, with two runs for each lane.
double seconds_of_trial(const Kernels& kernels) {
  LaneScheduler<TrialRun> scheduler(kernels);
  std::vector<std::unique_ptr<TrialRun>> runs;
  const int count = 2 * kernels.lanes;
  for (int i = 0; i < count; ++i) runs.push_back(std::make_unique<TrialRun>(0.05 + 0.3 * i / count));
  const double begin = thread_seconds();
  for (const auto& run : runs) scheduler.add(*run);
  while (scheduler.size() > 0) scheduler.step();
  return (thread_seconds() - begin) / count;
}

}  // namespace

std::vector<Kernels> fastest_last(std::vector<Kernels> kernels, const SecondsOfTrial& seconds) {
  const std::size_t count = kernels.size();
  if (count < 3) return kernels;
  Kernels& narrow = kernels[count - 2];
  Kernels& wide = kernels[count - 1];
  double of_narrow = std::numeric_limits<double>::infinity();
  double of_wide = of_narrow;
  for (int trial = 0; trial < 3; ++trial) {
    of_wide = std::min(of_wide, seconds(wide));
    of_narrow = std::min(of_narrow, seconds(narrow));
  }
  if (of_narrow < narrow_advantage * of_wide) std::swap(narrow, wide);
  return kernels;
}

std::span<const Kernels> available_kernels() {
  static const std::vector<Kernels> kernels = fastest_last(those_that_run_here(), seconds_of_trial);
  return kernels;
}

}  // namespace rocking::lanes
