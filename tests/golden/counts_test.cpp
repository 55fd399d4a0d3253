// Work per excitation period, as counts. Counts are exact and show additional work that a clock would not resolve. They
// are the same with every compiler and processor, as are the bits of the results.
//
// A failure prints the counts in the notation of this table. If the change is intended (a guard excluded by a cheaper
// bound, a longer step), enter the new row here and state the change of cost in the commit.

#include <numeric>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

/// Counts of one realisation over 100 periods.
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
  Condition condition = support::shaken(c.amplitude, c.friction);
  condition.scene.fluctuation = c.fluctuation;
  condition.horizon = {.transient_periods = 60, .sampled_periods = 40};
  condition.tolerance = c.tolerance;
  const RealisationResult result = realise_unchecked(condition, 0x2012, 0);
  EXPECT_EQ(result.strobe.size(), 100U) << "the block overturned: what was counted is less than 100 periods";
  const OperationCounts& operations = result.operations;
  return {.steps = operations.steps,
          .slip_steps = operations.slip_steps,
          .root_isolations = operations.root_isolations,
          .events = std::accumulate(operations.events.begin(), operations.events.end(), std::uint64_t{0}),
          .draws = operations.static_friction_draws + operations.kinetic_friction_draws + operations.restitution_draws +
                   operations.amplitude_draws + operations.initial_draws};
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
