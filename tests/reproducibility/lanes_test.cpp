// A realisation has the same bits as alone, whatever the other realisations, the number of lanes and the instruction
// set.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "golden/experiment.hpp"
#include "reproducibility/asked_scenes.hpp"
#include "reproducibility/lanes_crowds.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "support/excitation.hpp"
#include "support/random_scene.hpp"

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

/// Realisations that go on window by window, some of them with a long run.
std::vector<Condition> settling_crowd() {
  std::vector<Condition> conditions;
  for (const double amplitude : {5.5, 6.0, 7.0, 8.0}) {
    conditions.push_back(
        from_random_tilt(amplitude, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35}));
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

/// The bits of numbers that the digest does not cover.
std::string spelled(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += ' ' + std::to_string(std::bit_cast<std::uint64_t>(value));
  return text;
}

std::string spelled(const PeakValues& peaks) {
  return spelled({peaks.tilt, peaks.tilt_rate, peaks.slip, peaks.slip_m, peaks.final_slip, peaks.final_slip_m});
}

std::string spelled(const std::optional<section::ExponentEstimate>& estimate) {
  if (!estimate) return ", no exponent";
  return ", exponent " + std::to_string(estimate->exponent) + spelled({estimate->exponent, estimate->standard_error});
}

std::string spelled(const section::Classification& classification) {
  return ", " + to_string(classification.mode) + " since " +
         std::string(classification.reason ? to_string(*classification.reason) : "it ended") +
         (classification.in_transient ? ", in its transient," : ",") + " margin and held" +
         spelled({classification.margin, classification.held});
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
         std::to_string(operations.kinetic_friction_draws) + " draws, " + std::to_string(operations.exponent_periods) +
         " periods with tangents, " + std::to_string(result.losses_of_contact) + " losses, " +
         std::to_string(result.contradictions) + " contradictions" + spelled(result.classification) +
         spelled(result.exponent) + ", peaks" + spelled(result.peaks) +
         (result.overturned_side ? ", to the " + std::string(to_string(*result.overturned_side)) : "") + ", " +
         std::to_string(result.losses_before_fall) + " losses before the fall" + spelled(result.settling);
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

/// Number of realisations whose exponent was computed. name_of(task): for messages.
std::uint64_t expect_the_bits_alone(
    const std::vector<RequestedRun>& tasks,
    const std::function<std::string(std::size_t)>& name_of = [](std::size_t task) { return std::to_string(task); }) {
  std::vector<std::string> alone;
  std::uint64_t tangent_runs = 0;
  for (const RequestedRun& task : tasks) {
    const RealisationResult result = realise_unchecked(*task.condition, seed, task.realisation);
    tangent_runs += result.operations.exponent_periods > 0 ? 1 : 0;
    alone.push_back(spelled(result));
  }
  for (const lanes::Kernels& kernels : lanes::available_kernels()) {
    const auto together = side_by_side(kernels, tasks);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      EXPECT_EQ(together[i], alone[i]) << kernels.name << ": " << name_of(i) << ", realisation "
                                       << tasks[i].realisation;
    }
  }
  return tangent_runs;
}

std::uint64_t expect_the_bits_alone(const std::vector<Condition>& conditions) {
  return expect_the_bits_alone(mixed(conditions));
}

TEST(Lanes, GiveEachRealisationTheBitsThatItGetsAlone) { EXPECT_GT(expect_the_bits_alone(crowd()), 10U); }

TEST(Lanes, GiveEachRealisationThatIsRunUntilItIsClassifiedTheBitsThatItGetsAlone) {
  expect_the_bits_alone(settling_crowd());
}

/// Where most windows need an exponent, later ones are run with tangent vectors from their beginning.
TEST(Lanes, GiveEachRealisationOfWhichMostNeedAnExponentTheBitsThatItGetsAlone) {
  Condition condition = from_random_tilt(7.0, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
  condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
  condition.horizon = {.transient_periods = 20, .sampled_periods = 48};
  std::vector<RequestedRun> tasks;
  for (std::uint64_t realisation = 0; realisation < 300; ++realisation) tasks.push_back({&condition, realisation});
  const std::uint64_t with_exponent = expect_the_bits_alone(tasks);
  EXPECT_GT(with_exponent, 200U);
  EXPECT_LT(with_exponent, 280U) << "some need none";
}

/// The same conditions with blocks whose mass is off the middle.
std::vector<Condition> off_middle(std::vector<Condition> conditions, std::uint64_t draws) {
  support::SplitMix random(draws);
  for (Condition& condition : conditions) {
    const double left = random.uniform(0.25, 0.75);
    const double right = random.uniform(0.25, 0.75);
    const double height = random.uniform(1.0, 2.5);
    condition.scene.block.mass =
        GivenEdges{.edges = {left, right}, .centre_height = height, .radius_of_gyration = random.uniform(0.6, 1.6)};
  }
  return conditions;
}

TEST(Lanes, GiveEachRealisationOfBlocksWithTheirMassOffTheMiddleTheBitsThatItGetsAlone) {
  EXPECT_GT(expect_the_bits_alone(off_middle(crowd(), 68)), 10U);
  expect_the_bits_alone(off_middle(recorded_crowd(), 69));
  expect_the_bits_alone(off_middle(pulse_crowd(), 70));
  std::vector<Condition> both = off_middle(crowd(), 71);  // beside rectangles
  const std::vector<Condition> rectangles = crowd();
  both.insert(both.end(), rectangles.begin(), rectangles.end());
  expect_the_bits_alone(both);
}

// A rectangle whose numbers are given as those of a general block.
TEST(Lanes, GiveARectangleTheSameBitsHoweverItIsDescribed) {
  support::SplitMix random(72);
  for (int i = 0; i < 1000; ++i) {
    Condition condition;
    condition.scene = support::random_scene(random);
    condition.horizon = {.transient_periods = 3, .sampled_periods = 5};
    const double width = random.uniform(0.3, 2.0);
    const double height = random.uniform(1.0, 5.0);
    condition.scene.block = {.width = width, .height = height};
    const RealisationResult as_rectangle = realise_unchecked(condition, seed, 0);
    condition.scene.block = {
        .width = 9.0,
        .height = 9.0,
        .mass = GivenEdges{.edges = {0.5 * width, 0.5 * width},
                           .centre_height = 0.5 * height,
                           .radius_of_gyration = std::sqrt((width * width + height * height) / 12.0)}};
    EXPECT_EQ(spelled(realise_unchecked(condition, seed, 0)), spelled(as_rectangle)) << i;
  }
}

// Scenes that nobody has chosen, in the lanes of every instruction set that this machine has.
TEST(Lanes, GiveEachRealisationOfRandomScenesTheBitsThatItGetsAlone) {
  constexpr int scenes = 131;
  support::SplitMix random(65);
  std::vector<Condition> conditions;
  for (int i = 0; i < scenes; ++i) {
    Condition condition;
    condition.scene = support::random_scene(random);
    condition.horizon = {.transient_periods = random.below(20), .sampled_periods = 20};
    condition.realisations = 3;
    if (random.below(8) == 0) condition.tolerance = 1e-7;
    conditions.push_back(condition);
  }
  expect_the_bits_alone(conditions);
}

// The end of a cell of the friction depends on the part of a tangent vector along X, which kernels do not know.
TEST(Lanes, GiveTheLabelAndTheExponentAloneInEveryKindOfSceneThatAFileCanAskFor) {
  const std::vector<AskedScene> scenes = asked_scenes();
  std::vector<Condition> conditions;
  for (const AskedScene& scene : scenes) conditions.push_back(scene.condition);
  EXPECT_GT(conditions.size(), 200U);
  EXPECT_GT(expect_the_bits_alone(mixed(conditions), [&](std::size_t task) { return scenes[task].name; }), 100U);
}

TEST(Lanes, GiveEachRealisationUnderAGroundMotionTheBitsThatItGetsAlone) {
  EXPECT_EQ(expect_the_bits_alone(recorded_crowd()), 0U);
}

TEST(Lanes, GiveEachRealisationUnderVerticalMotionTheBitsThatItGetsAlone) {
  expect_the_bits_alone(vertical_crowd());
  expect_the_bits_alone(off_middle(vertical_crowd(), 71));
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

/// The order of lanes of 1, 8 and 16 by the time of a run in each, in turn for each trial.
std::vector<int> order_by(const std::vector<double>& of_eight, const std::vector<double>& of_sixteen) {
  std::vector<lanes::Kernels> kernels(3);
  kernels[0].lanes = 1;
  kernels[1].lanes = 8;
  kernels[2].lanes = 16;
  std::size_t eights = 0;
  std::size_t sixteens = 0;
  const auto sorted = lanes::fastest_last(kernels, [&](const lanes::Kernels& tried) {
    EXPECT_NE(tried.lanes, 1) << "it is never the fastest";
    return tried.lanes == 8 ? of_eight.at(eights++) : of_sixteen.at(sixteens++);
  });
  std::vector<int> order;
  for (const lanes::Kernels& some : sorted) order.push_back(some.lanes);
  return order;
}

TEST(Lanes, AreTheNarrowerOnesWhereTheseAreClearlyFaster) {
  EXPECT_THAT(order_by({0.90, 0.90, 0.90}, {1.0, 1.0, 1.0}), testing::ElementsAre(1, 16, 8));
  EXPECT_THAT(order_by({0.97, 0.97, 0.97}, {1.0, 1.0, 1.0}), testing::ElementsAre(1, 8, 16)) << "not clearly";
  EXPECT_THAT(order_by({5.0, 0.90, 5.0}, {1.0, 9.0, 9.0}), testing::ElementsAre(1, 16, 8)) << "the best of each counts";
  EXPECT_THAT(order_by({0.90, 0.90, 0.90}, {9.0, 9.0, 0.90}), testing::ElementsAre(1, 8, 16)) << "up to the last trial";
}

TEST(Lanes, AreNotTriedWhereThereIsOneWidth) {
  const auto never = [](const lanes::Kernels&) -> double { throw std::logic_error("tried"); };
  EXPECT_THAT(lanes::fastest_last(std::vector<lanes::Kernels>(2), never), testing::SizeIs(2));
}

TEST(Lanes, AllocateNothingInTheInnerLoop) {
  Condition condition = from_random_tilt(4.5, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
  condition.scene.fluctuation.kinetic_friction = 0.03;
  condition.scene.fluctuation.static_friction = 0.03;
  condition.horizon.transient_periods = 20'000;
  using Run = HorizonRun;
  lanes::LaneScheduler<Run> scheduler(lanes::available_kernels().back());
  std::vector<std::unique_ptr<Run>> runs;
  for (std::uint64_t number = 0; number < scheduler.wanted_size(); ++number) {
    const random::Draws draws(seed, number);
    const Beginning beginning = begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare,
                                                  strobes_before_window(condition));
    runs.push_back(std::make_unique<Run>(condition, draws, beginning, [&](dynamics::Observer& observer) {
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
  std::uint64_t exponent_periods = 0;
  std::uint64_t allocations = 0;
};

/// Work of realisations whose classification needs the exponent, over at least the sampled periods.
Work work_of_tangents(int sampled_periods) {
  Condition condition = from_random_tilt(8.0, Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35});
  support::harmonic(condition.scene).phase = Uniform{.low = 0.0, .high = 6.0};
  condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.02;
  condition.horizon = {.transient_periods = 100, .sampled_periods = sampled_periods};
  const std::uint64_t before = allocations;
  Work work;
  RealisationScheduler scheduler(seed, lanes::available_kernels().back());
  for (std::uint64_t number = 0; number < 60 || !scheduler.is_idle();) {
    for (; number < 60 && scheduler.wants_more(); ++number) scheduler.start({&condition, number}, number);
    for (const auto& [id, result] : scheduler.work()) work.exponent_periods += result.operations.exponent_periods;
  }
  work.allocations = allocations - before;
  return work;
}

TEST(Lanes, AllocateForNoPeriodWithTangents) {
  const Work some = work_of_tangents(400);
  const Work more = work_of_tangents(800);
  const std::uint64_t more_periods = more.exponent_periods - some.exponent_periods;
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

// g++ makes fused operations of products with alternating signs where it vectorises straight-line code, although
// contraction is off. A motion alone then has other bits than a lane.
TEST(Lanes, AreComparedWithCodeInWhichNothingIsFusedThatIsNotWrittenSo) {
  const auto rooms = std::filesystem::path(ROCKING_PROGRAM).parent_path() / "lib/rocking";
  int instructions = 0;
  for (const std::string room : {"dynamics", "integrate", "lanes", "realisation", "scene", "section"}) {
    const auto library = rooms / room / ("librocking_" + room + ".a");
    for (const std::string& line : output_of("objdump -d --no-show-raw-insn '" + library.string() + "'")) {
      ++instructions;
      EXPECT_EQ(line.find("fmaddsub"), std::string::npos) << room << line;
      EXPECT_EQ(line.find("fmsubadd"), std::string::npos) << room << line;
    }
  }
  EXPECT_GT(instructions, 10'000);
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
