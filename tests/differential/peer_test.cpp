// Our trajectories, compared with those of an independent implementation on SUNDIALS (reports/evidence/differential.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "differential/compare.hpp"
#include "differential/peer/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/realisation/trajectory.hpp"

namespace rocking::differential {
namespace {

/// The peer may differ from us by as much as a displacement of 1e-9 changes our own run.
constexpr double share_allowed = 1.0;

struct Totals {
  std::array<int, 4> outcomes{};
  int looked_closer = 0;
  std::size_t entries = 0;

  [[nodiscard]] int of(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
};

/// Adds a scene; prints it if the two disagree.
void ask(const Question& question, Totals& totals) {
  const Comparison comparison = compare(question, question, share_allowed);
  ++totals.outcomes[static_cast<std::size_t>(comparison.outcome)];
  totals.looked_closer += comparison.looked_closer ? 1 : 0;
  totals.entries += comparison.entries;
  EXPECT_NE(comparison.outcome, Outcome::disagreed)
      << "question " << question.realisation << ": entry " << comparison.entries << ", difference "
      << comparison.difference << ", as a share of the displacement " << comparison.share;
}

constexpr std::uint64_t block_size = 100;
constexpr std::uint64_t uniform_scenes = 1'000;  ///< then as many of blocks with their mass off the middle

/// A group of scenes; groups can run in parallel.
class DifferentialFuzz : public testing::TestWithParam<std::uint64_t> {};

TEST_P(DifferentialFuzz, AgreesWithAnIndependentBlockUntilRoundOffHasGrown) {
  Totals totals;
  for (std::uint64_t i = 0; i < block_size; ++i) {
    const std::uint64_t number = GetParam() * block_size + i;
    ask(number < uniform_scenes ? random_question(number) : random_general_question(number), totals);
  }
  EXPECT_LE(totals.of(Outcome::split), 2) << "other lists of events, where ours is as fragile: below 2 % of scenes";
  EXPECT_LE(totals.of(Outcome::grown), 5) << "scenes that say nothing at their end";
  EXPECT_LE(totals.looked_closer, 3) << "dips that the peer missed at first";
  EXPECT_GT(totals.entries, 10 * block_size) << "the scenes have become dull";
}

INSTANTIATE_TEST_SUITE_P(Scenes, DifferentialFuzz, testing::Range<std::uint64_t>(0, 20));

// Blocks with unequal edges and a moment of inertia of their own under one cycle of a sine: impacts and overturning.
TEST(Pulse, OverturnsBlocksToBothSidesAtTheInstantsOfAnIndependentBlock) {
  Totals totals;
  std::array<int, 2> overturned{};  // to the left, to the right
  for (std::uint64_t number = 0; number < 4 * block_size; ++number) {
    const Question question = random_pulse_question(number);
    ask(question, totals);
    const auto events = trajectory_of(question.condition, 0, number, question.periods).events;
    if (events.empty() || events.back().kind != dynamics::EventKind::overturn) continue;
    ++overturned[events.back().tilt < 0.0 ? 1 : 0];
  }
  EXPECT_GT(overturned[0], 50);
  EXPECT_GT(overturned[1], 50);
  EXPECT_EQ(totals.of(Outcome::split), 0);
  EXPECT_LE(totals.of(Outcome::grown), 4);
}

/// A group of scenes at a wall: harmonic, pulse and record, with vertical motion, drawn rate ratios, general blocks.
class DifferentialWalls : public testing::TestWithParam<std::uint64_t> {};

TEST_P(DifferentialWalls, AgreeWithAnIndependentBlockUntilRoundOffHasGrown) {
  Totals totals;
  for (std::uint64_t i = 0; i < block_size; ++i) ask(random_wall_question(GetParam() * block_size + i), totals);
  EXPECT_EQ(totals.of(Outcome::split), 0);
  EXPECT_LE(totals.of(Outcome::grown), 2);
  EXPECT_LE(totals.looked_closer, 1);
  EXPECT_GT(totals.entries, 10 * block_size);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DifferentialWalls, testing::Range<std::uint64_t>(0, 10));

/// Number of the first scenes that reveal the difference if the peer's question is changed.
template <class Change>
int noticed(int scenes, Change change, Question (&question_of)(std::uint64_t) = random_question) {
  int count = 0;
  for (int i = 0; i < scenes; ++i) {
    const Question ours = question_of(static_cast<std::uint64_t>(i));
    Question theirs = ours;
    change(theirs.condition.scene);
    const Outcome outcome = compare(ours, theirs, share_allowed).outcome;
    if (outcome == Outcome::disagreed) ++count;
  }
  return count;
}

TEST(Differential, ItsScenesKnowEveryKindOfEvent) {
  std::set<std::string_view> kinds;
  for (std::uint64_t number = 0; number < 4 * block_size; ++number) {
    const Question question = random_question(number);
    for (const peer::Event& event : peer::story_of(peer_scene(question), question.periods).events)
      kinds.insert(event.kind);
  }
  EXPECT_EQ(kinds.size(), dynamics::event_kind_count) << testing::PrintToString(kinds);
}

TEST(Differential, NoticesARestitutionThatIsOffByATenMillionth) {
  const auto change = [](Scene& scene) { scene.restitution = mean_of(std::get<Quantity>(scene.restitution)) + 1e-7; };
  EXPECT_GE(noticed(20, change), 5);
}

TEST(Differential, NoticesARateRatioOfAWallThatIsOffByATenMillionth) {
  const auto change = [](Scene& scene) {
    auto& wall = std::get<WallRatio>(scene.restitution);
    wall.value = mean_of(wall.value) + 1e-7;
  };
  EXPECT_GE(noticed(20, change, random_wall_question), 5);
}

TEST(Differential, NoticesAFrictionThatIsOffByATenMillionth) {
  const auto change = [](Scene& scene) {
    if (scene.friction) scene.friction->kinetic_coefficient = mean_kinetic(*scene.friction) * (1.0 - 1e-7);
  };
  EXPECT_GE(noticed(20, change), 5);
}

TEST(Differential, NoticesAGridOfFrictionThatIsOneIntervalFiner) {
  const auto change = [](Scene& scene) { scene.fluctuation.refreshes_per_period += 1; };
  EXPECT_GE(noticed(20, change), 1);
}

TEST(Differential, NoticesAMomentOfInertiaThatIsOffByATenMillionth) {
  const auto change = [](Scene& scene) {
    auto& mass = std::get<GivenEdges>(scene.block.mass);
    mass.radius_of_gyration = mean_of(mass.radius_of_gyration) * (1.0 + 0.5e-7);
  };
  EXPECT_GE(noticed(20, change, random_general_question), 5);
  EXPECT_GE(noticed(60, change, random_pulse_question), 5);
}

TEST(Differential, NoticesTheOtherInertia) {
  const auto change = [](Scene& scene) {
    scene.slide_inertia = scene.slide_inertia == dynamics::SlideInertia::edge ? dynamics::SlideInertia::centroidal
                                                                              : dynamics::SlideInertia::edge;
  };
  EXPECT_GE(noticed(20, change), 5);
}

}  // namespace
}  // namespace rocking::differential
