// What a period of the excitation costs, in counted work: exact, so that work that creeps in shows where a clock would
// waver. The counts are the same with every compiler and processor, as the bits of the results are.
//
// A failure says what was counted, in the notation of this table. If the change of work is meant (a guard that is cleared
// by a cheaper bound, a step that is longer), put the new row here and say in the commit what became of the cost.

#include <numeric>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "rocking/experiment/record.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using namespace experiment;

/// Of one realisation, over 100 periods.
struct Work {
  std::uint64_t steps;
  std::uint64_t slip_steps;
  std::uint64_t root_isolations;
  std::uint64_t events;
  std::uint64_t draws;

  friend bool operator==(const Work&, const Work&) = default;
};

void PrintTo(const Work& work, std::ostream* stream) {
  *stream << "{" << work.steps << ", " << work.slip_steps << ", " << work.root_isolations << ", " << work.events << ", "
          << work.draws << "}";
}

/// A block of H/B = 4 at Omega_h = 10, from rest.
struct Case {
  std::string name;
  double amplitude;
  std::optional<Friction> friction;
  Fluctuation fluctuation;
  double tolerance;
  Work work;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

Work work_of(const Case& c) {
  Condition condition;
  support::harmonic(condition.scene).amplitude = c.amplitude;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.friction = c.friction;
  condition.scene.fluctuation = c.fluctuation;
  condition.horizon = {.transient_periods = 60, .sampled_periods = 40};
  condition.tolerance = c.tolerance;
  const Record record = realise(condition, 0x2012, 0);
  EXPECT_EQ(record.strobe.size(), 100U) << "the block overturned: what was counted is less than 100 periods";
  const Effort& effort = record.effort;
  return {.steps = effort.steps,
          .slip_steps = effort.slip_steps,
          .root_isolations = effort.root_isolations,
          .events = std::accumulate(effort.events.begin(), effort.events.end(), std::uint64_t{0}),
          .draws = effort.static_friction_draws + effort.kinetic_friction_draws + effort.restitution_draws +
                   effort.amplitude_draws + effort.initial_draws};
}

class Counts : public testing::TestWithParam<Case> {};

TEST_P(Counts, AreWhatTheyWere) { EXPECT_EQ(work_of(GetParam()), GetParam().work); }

constexpr Friction rough{.static_coefficient = 2.0, .kinetic_coefficient = 1.9};
constexpr Friction smooth{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};

INSTANTIATE_TEST_SUITE_P(
    Scenes, Counts,
    testing::Values(Case{"no_sliding", 4.5, {}, {}, 1e-13, {1144, 0, 67, 67, 0}},
                    Case{"no_sliding_at_a_coarser_tolerance", 4.5, {}, {}, 1e-8, {530, 0, 76, 67, 0}},
                    Case{"sliding_possible_but_absent", 4.5, rough, {}, 1e-13, {1144, 0, 67, 67, 0}},
                    Case{"sliding", 7.0, smooth, {}, 1e-13, {1409, 772, 762, 637, 0}},
                    Case{"fluctuating_friction",
                         7.0,
                         smooth,
                         {.static_friction = 0.03, .kinetic_friction = 0.03},
                         1e-13,
                         {6892, 5866, 638, 390, 5923}},
                    Case{"fluctuating_restitution", 4.5, {}, {.restitution = 0.01}, 1e-13, {1149, 0, 69, 67, 66}},
                    Case{"fluctuating_amplitude", 4.5, {}, {.amplitude = 0.1}, 1e-13, {1203, 0, 74, 67, 101}}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace rocking
