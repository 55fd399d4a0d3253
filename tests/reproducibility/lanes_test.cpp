// A realisation has the same bits as alone, whatever the other realisations, the number of lanes and the instruction
// set.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "golden/experiment.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/realisation_digest.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "support/excitation.hpp"

namespace {
std::uint64_t allocations = 0;
}

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace rocking {
namespace {

Condition shaken(double amplitude, std::optional<Friction> friction = std::nullopt) {
  Condition condition;
  support::harmonic(condition.scene).amplitude = amplitude;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.friction = friction;
  condition.scene.initial.tilt = Uniform{.low = -0.4, .high = 0.4};
  condition.horizon = {.transient_periods = 30, .sampled_periods = 30};
  condition.realisations = 12;
  return condition;
}

/// A ground motion of a sine, with `spacing` periods between samples, with or without a vertical part and jumps; one
/// strobe a period.
GroundMotion sampled_sine(double spacing, double vertical, bool jumps) {
  Condition reference;
  const double p = dynamics::geometry_of(mean_block(reference.scene)).frequency_parameter;
  const double period = 0.2 * std::numbers::pi;
  GroundMotion motion{.samples = {}, .has_vertical = vertical > 0.0};
  for (int i = 0; i * spacing < 40.0; ++i) {
    const double periods = i * spacing + (i % 3 == 0 ? 0.2 * spacing : 0.0);
    const double angle = 2.0 * std::numbers::pi * periods;
    motion.samples.push_back({periods * period / p, 1.1 * std::sin(angle), vertical * std::sin(1.7 * angle)});
    if (jumps && i % 7 == 0) {
      motion.samples.push_back({periods * period / p, -0.3, 0.2 * vertical});
      if (i % 14 == 0) motion.samples.push_back({periods * period / p, 0.9 * std::cos(angle), -0.2 * vertical});
    }
  }
  return motion;
}

Condition recorded(GroundMotion motion, double scale, std::optional<Friction> friction = std::nullopt) {
  Condition condition;
  condition.scene.excitation = support::recorded_by(std::move(motion), 10.0, scale);
  condition.scene.friction = friction;
  condition.scene.initial.tilt = Uniform{.low = -0.4, .high = 0.4};
  condition.horizon = {.transient_periods = 0, .sampled_periods = 42};
  condition.realisations = 6;
  return condition;
}

/// Ground motions with samples closer than the short steps and farther apart, with every contact state.
std::vector<Condition> recorded_crowd() {
  std::vector<Condition> conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  const Friction smooth{.static_coefficient = 0.25, .kinetic_coefficient = 0.22};
  for (const double spacing : {1.0 / 250.0, 1.0 / 130.0, 1.0 / 90.0, 0.11}) {
    for (const bool jumps : {false, true}) {
      const GroundMotion motion = sampled_sine(spacing, jumps ? 0.3 : 0.0, jumps);
      conditions.push_back(recorded(motion, 1.0));
      conditions.push_back(recorded(motion, 0.9, rough));
      conditions.push_back(recorded(motion, 1.6, smooth));
      conditions.push_back(recorded(motion, 1.2, rough));
      conditions.back().scene.fluctuation.kinetic_friction = 0.05;
      conditions.back().scene.fluctuation.static_friction = 0.03;
      conditions.push_back(recorded(motion, 1.0, rough));
      conditions.back().scene.fluctuation.amplitude = 0.2;  // its jumps are no knots
      conditions.push_back(recorded(motion, 1.0, rough));
      std::get<Recorded>(conditions.back().scene.excitation).scale = Lognormal{.mean = 1.0, .sigma = 0.3};
      conditions.push_back(recorded(motion, 1.0, rough));
      conditions.back().tolerance = 1e-6;
    }
  }
  return conditions;
}

/// Pulses of every shape, one after another and with harmonic shaking in the lanes beside them, with every kind of
/// contact; their ends among the boundaries of fine and coarse friction grids.
std::vector<Condition> pulse_crowd() {
  std::vector<Condition> conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  const Friction smooth{.static_coefficient = 0.25, .kinetic_coefficient = 0.22};
  for (const auto shape : {dynamics::PulseShape::sine, dynamics::PulseShape::cosine, dynamics::PulseShape::ricker}) {
    for (const double amplitude : {1.3, 4.0, 9.0}) {
      Condition condition = shaken(1.0);
      condition.scene.excitation = Pulse{.shape = shape, .amplitude = amplitude, .frequency_ratio = 7.0};
      condition.horizon = {.transient_periods = 0, .sampled_periods = 12};
      condition.realisations = 6;
      conditions.push_back(condition);
      condition.scene.friction = rough;
      conditions.push_back(condition);
      condition.scene.friction = smooth;
      conditions.push_back(condition);
      condition.scene.fluctuation.amplitude = 0.4;
      for (const int refreshes : {7, 133, 200, 1000}) {
        condition.scene.fluctuation.kinetic_friction = 0.05;
        condition.scene.fluctuation.refreshes_per_period = refreshes;
        conditions.push_back(condition);
      }
      condition.scene.fluctuation.static_friction = 0.03;
      condition.scene.fluctuation.restitution = 0.02;
      conditions.push_back(condition);
    }
  }
  conditions.push_back(shaken(4.5));
  conditions.push_back(shaken(7.0, rough));
  return conditions;
}

/// All cases that occur in lanes: rocking with and without friction, slip, coarse and fine grids, amplitudes that jump,
/// chatter and rest, overturning, a slip that ends the model, other blocks and tolerances.
std::vector<Condition> crowd() {
  std::vector<Condition> conditions = golden::golden_experiment().conditions;
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  conditions.push_back(shaken(4.5));
  conditions.push_back(shaken(9.0));
  conditions.push_back(shaken(7.0, rough));
  conditions.push_back(shaken(1.0, rough));
  conditions.push_back(shaken(6.0, Friction{.static_coefficient = 0.25, .kinetic_coefficient = 0.22}));
  for (const int refreshes : {3, 70, 130, 200}) {
    conditions.push_back(shaken(6.6, rough));
    conditions.back().scene.fluctuation.kinetic_friction = 0.05;
    conditions.back().scene.fluctuation.refreshes_per_period = refreshes;
    support::harmonic(conditions.back().scene).phase = Uniform{.low = 0.0, .high = 6.0};
  }
  conditions.push_back(shaken(6.6, rough));  // friction clamped at 0 and at the static one
  conditions.back().scene.fluctuation.kinetic_friction = 0.3;
  conditions.back().scene.fluctuation.refreshes_per_period = 200;
  conditions.push_back(shaken(5.0));
  conditions.back().scene.fluctuation.amplitude = 0.5;
  conditions.push_back(shaken(6.6, rough));
  conditions.back().scene.fluctuation.amplitude = 0.5;
  conditions.back().scene.fluctuation.kinetic_friction = 0.05;
  conditions.push_back(shaken(8.0, rough));  // its classification needs the exponent
  support::harmonic(conditions.back().scene).phase = Uniform{.low = 0.0, .high = 6.0};
  conditions.back().scene.fluctuation.static_friction = conditions.back().scene.fluctuation.kinetic_friction = 0.02;
  conditions.back().horizon = {.transient_periods = 200, .sampled_periods = 120};
  for (const FluctuationLaw law : {FluctuationLaw::lognormal, FluctuationLaw::uniform}) {  // correlated friction
    conditions.push_back(shaken(6.6, rough));
    Fluctuation& fluctuation = conditions.back().scene.fluctuation;
    fluctuation = {.static_friction = 0.03, .kinetic_friction = 0.04, .friction_correlation = 0.7};
    fluctuation.laws.static_friction = fluctuation.laws.kinetic_friction = law;
  }
  conditions.push_back(shaken(1.0));  // every number drawn once
  support::harmonic(conditions.back().scene).amplitude = Lognormal{.mean = 6.0, .sigma = 2.0};
  support::harmonic(conditions.back().scene).frequency_ratio = Uniform{.low = 8.0, .high = 12.0};
  conditions.back().scene.restitution = Triangular{.low = 0.0, .mode = 0.1, .high = 0.3};
  conditions.back().scene.friction =
      Friction{.static_coefficient = Normal{.mean = 0.4, .sigma = 0.05}, .kinetic_ratio = 0.9};
  conditions.push_back(shaken(0.6));  // chatters to rest, repeatedly
  conditions.push_back(shaken(4.5));
  conditions.back().scene.fluctuation.restitution = 0.05;
  conditions.push_back(shaken(30.0));
  support::harmonic(conditions.back().scene).frequency_ratio = 1.0;
  conditions.push_back(shaken(7.0, Friction{.static_coefficient = 1.6, .kinetic_coefficient = 1.5}));
  conditions.back().scene.block = {.width = 1.0, .height = 0.9, .gravity = 9.81};
  conditions.push_back(shaken(4.5));
  conditions.back().tolerance = 1e-5;
  return conditions;
}

/// Realisations that go on window by window, some of them with a long run.
std::vector<Condition> settling_crowd() {
  std::vector<Condition> conditions;
  for (const double amplitude : {5.5, 6.0, 7.0, 8.0}) {
    conditions.push_back(shaken(amplitude, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35}));
    Condition& condition = conditions.back();
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
    condition.horizon.until_classified =
        UntilClassified{.at_most_periods = 600, .held_windows = 2, .watch_windows = 1, .long_run_every = 3};
    if (amplitude == 6.0) condition.horizon.until_classified->exponent_pause = 2;
  }
  return conditions;
}

/// All realisations of these conditions, those of one condition far apart.
std::vector<RequestedRun> mixed(const std::vector<Condition>& conditions) {
  std::vector<RequestedRun> tasks;
  for (std::uint64_t realisation = 0; realisation < 12; ++realisation) {
    for (const Condition& condition : conditions) {
      if (realisation < condition.realisations) tasks.push_back({&condition, realisation});
    }
  }
  return tasks;
}

constexpr std::uint64_t seed = 0x2012;

/// The bits of the peaks, which the digest does not cover.
std::string spelled(const PeakValues& peaks) {
  std::string text;
  for (const double value :
       {peaks.tilt, peaks.tilt_rate, peaks.slip, peaks.slip_m, peaks.final_slip, peaks.final_slip_m}) {
    text += ' ' + std::to_string(std::bit_cast<std::uint64_t>(value));
  }
  return text;
}

std::string spelled(const std::optional<Settling>& settling) {
  if (!settling) return "";
  return ", " + to_string(settling->horizon_mode) + " of " + std::to_string(settling->observed_periods) +
         " periods, settled " + std::to_string(settling->settling_period.value_or(-1)) + ", left " +
         std::to_string(settling->left_period.value_or(-1)) + ", long run " +
         (settling->long_run ? to_string(*settling->long_run) : "none");
}

/// All parts of a result as text, including the counts of work.
std::string spelled(const RealisationResult& result) {
  const OperationCounts& operations = result.operations;
  return base::to_hex(digest_of(result, 0)) + " " + std::to_string(operations.steps) + " steps, " +
         std::to_string(operations.slip_steps) + " with slip, " + std::to_string(operations.root_isolations) +
         " isolations, " + std::to_string(operations.ground_motion_segments) + " segments, " +
         std::to_string(operations.kinetic_friction_draws) + " draws, " +
         std::to_string(operations.perturbed_pair_periods) + " periods of perturbed pairs, " +
         std::to_string(result.losses_of_contact) + " losses, " + std::to_string(result.contradictions) +
         " contradictions, margin " + std::to_string(result.classification.margin) + ", peaks" + spelled(result.peaks) +
         ", " + std::to_string(result.losses_before_fall) + " losses before the fall" + spelled(result.settling);
}

std::vector<std::string> side_by_side(const lanes::Kernels& kernels, const std::vector<RequestedRun>& tasks) {
  std::vector<std::string> spellings(tasks.size());
  RealisationScheduler scheduler(seed, kernels);
  for (std::size_t next = 0; next < tasks.size() || !scheduler.is_idle();) {
    for (; next < tasks.size() && scheduler.wants_more(); ++next) scheduler.start(tasks[next], next);
    for (const auto& [id, result] : scheduler.work()) spellings[id] = spelled(result);
  }
  return spellings;
}

/// Number of realisations whose exponent was computed.
std::uint64_t expect_the_bits_alone(const std::vector<Condition>& conditions) {
  const std::vector<RequestedRun> tasks = mixed(conditions);
  std::vector<std::string> alone;
  std::uint64_t perturbed_pairs = 0;
  for (const RequestedRun& task : tasks) {
    const RealisationResult result = realise_unchecked(*task.condition, seed, task.realisation);
    perturbed_pairs += result.operations.perturbed_pair_periods > 0 ? 1 : 0;
    alone.push_back(spelled(result));
  }
  for (const lanes::Kernels& kernels : lanes::available_kernels()) {
    const auto together = side_by_side(kernels, tasks);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      EXPECT_EQ(together[i], alone[i]) << kernels.name << ": condition " << tasks[i].condition - conditions.data()
                                       << ", realisation " << tasks[i].realisation;
    }
  }
  return perturbed_pairs;
}

TEST(Lanes, GiveEachRealisationTheBitsThatItGetsAlone) { EXPECT_GT(expect_the_bits_alone(crowd()), 10U); }

TEST(Lanes, GiveEachRealisationThatIsRunUntilItIsClassifiedTheBitsThatItGetsAlone) {
  expect_the_bits_alone(settling_crowd());
}

TEST(Lanes, GiveEachRealisationUnderAGroundMotionTheBitsThatItGetsAlone) {
  EXPECT_EQ(expect_the_bits_alone(recorded_crowd()), 0U);
}

TEST(Lanes, GiveEachRealisationUnderAPulseTheBitsThatItGetsAlone) { expect_the_bits_alone(pulse_crowd()); }

TEST(Lanes, OfEveryWidthGiveTheSameRun) {
  Experiment experiment = golden::golden_experiment();
  std::map<std::string, std::string> digests;
  for (const lanes::Kernels& kernels : lanes::available_kernels()) {
    RunOptions options;
    options.threads = 2;
    options.lanes = kernels;
    digests[base::to_hex(run(experiment, options)->digest)] += std::string(kernels.name) + "; ";
  }
  EXPECT_THAT(digests, testing::SizeIs(1));
}

TEST(Lanes, ComeInTheWidthsOfTheInstructionSets) {
  std::vector<int> widths;
  for (const lanes::Kernels& kernels : lanes::available_kernels()) widths.push_back(kernels.lanes);
  EXPECT_EQ(widths.front(), 1);
#if defined(__AVX2__)
  EXPECT_THAT(widths, testing::Contains(8));
#endif
}

TEST(Lanes, AllocateNothingInTheInnerLoop) {
  Condition condition = shaken(4.5, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
  condition.scene.fluctuation.kinetic_friction = 0.03;
  condition.scene.fluctuation.static_friction = 0.03;
  condition.horizon.transient_periods = 20'000;
  using Run = HorizonRun;
  lanes::LaneScheduler<Run> scheduler(lanes::available_kernels().back());
  std::vector<std::unique_ptr<Run>> runs;
  for (std::uint64_t number = 0; number < scheduler.wanted_size(); ++number) {
    const random::Draws draws(seed, number);
    const Beginning beginning = begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare,
                                                  strobes_before_copy(condition));
    runs.push_back(std::make_unique<Run>(condition, beginning, [&](dynamics::Observer& observer) {
      return motion_of(condition.scene, beginning, observer);
    }));
    scheduler.add(*runs.back());
  }
  const auto steps = [&scheduler](int count) {
    for (int i = 0; i < count; ++i) scheduler.step();
  };
  steps(20'000);  // buffers grow to the size that they need
  const std::uint64_t before = allocations;
  steps(20'000);
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_EQ(scheduler.take_finished(), nullptr) << "a run that ends allocates, and is not what is tested here";
}

struct Work {
  std::uint64_t perturbed_pair_periods = 0;
  std::uint64_t allocations = 0;
};

/// Work of realisations whose classification needs the exponent, over at least the sampled periods.
Work work_of_perturbed_pairs(int sampled_periods) {
  Condition condition = shaken(8.0, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
  support::harmonic(condition.scene).phase = Uniform{.low = 0.0, .high = 6.0};
  condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.02;
  condition.horizon = {.transient_periods = 100, .sampled_periods = sampled_periods};
  const std::uint64_t before = allocations;
  Work work;
  RealisationScheduler scheduler(seed, lanes::available_kernels().back());
  for (std::uint64_t number = 0; number < 60 || !scheduler.is_idle();) {
    for (; number < 60 && scheduler.wants_more(); ++number) scheduler.start({&condition, number}, number);
    for (const auto& [id, result] : scheduler.work())
      work.perturbed_pair_periods += result.operations.perturbed_pair_periods;
  }
  work.allocations = allocations - before;
  return work;
}

TEST(Lanes, AllocateForNoPeriodOfPerturbedPairs) {
  const Work some = work_of_perturbed_pairs(400);
  const Work more = work_of_perturbed_pairs(800);
  const std::uint64_t more_periods = more.perturbed_pair_periods - some.perturbed_pair_periods;
  EXPECT_GT(more_periods, 10'000U);
  EXPECT_LT(more.allocations - some.allocations, more_periods / 4) << "those of naming twice as many points are fewer";
}

/// The lines that a command prints.
std::vector<std::string> output_of(const std::string& command) {
  std::vector<std::string> lines;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return lines;
  char* line = nullptr;
  for (std::size_t size = 0; getline(&line, &size, pipe) > 0;) lines.emplace_back(line, std::strcspn(line, "\n"));
  std::free(line);
  pclose(pipe);
  return lines;
}

// The linker could use an inline function of a standard container that was compiled for AVX-512 in the whole program,
// which would crash on an older processor. Such units must not share functions with others.
TEST(Lanes, ShareNothingThatWasCompiledForANewerProcessor) {
#if ROCKING_CONTRACTS
  GTEST_SKIP() << "sanitizers and contracts add symbols of their own";
#endif
  const auto rooms = std::filesystem::path(ROCKING_PROGRAM).parent_path() / "lib/rocking";
  for (const std::string library : {"lanes/librocking_lanes.a", "random/librocking_random.a"}) {
    std::string unit;
    int kernels = 0;
    for (const std::string& line : output_of("nm -C '" + (rooms / library).string() + "'")) {
      if (line.ends_with(".o:")) unit = line;
      if (unit.find("_avx") == std::string::npos && unit.find("_neon") == std::string::npos) continue;
      ++kernels;
      const bool is_shared = line.find(" W ") != std::string::npos || line.find(" V ") != std::string::npos ||
                             line.find(" u ") != std::string::npos;
      EXPECT_FALSE(is_shared) << unit << " " << line;
    }
    EXPECT_GT(kernels, 0) << library;
  }
}

}  // namespace
}  // namespace rocking
