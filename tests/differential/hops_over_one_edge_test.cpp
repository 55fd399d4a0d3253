// The smallest scene of what the fuzz test found about squat blocks (reports/evidence/differential.md).

#include <gtest/gtest.h>

#include "differential/account.hpp"
#include "differential/peer/block.hpp"
#include "differential/random_scene.hpp"

namespace rocking::differential {
namespace {

// If delta < 0, a block turns about the same edge again, in ever lower hops. While the base pushes it over the other
// edge it cannot rest: after a finite time it comes down and leaves at once.
TEST(HopsOverOneEdge, EndInALiftOverTheOther) {
  Question question{.condition = {}, .seed = 0, .realisation = 0, .periods = 3};
  Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = 1.2};
  scene.excitation = Harmonic{.amplitude = 2.0, .frequency_ratio = 10.0, .phase = 0.0};
  scene.restitution = 0.7;
  const peer::Story expected = peer::story_of(peer_scene(question), question.periods);
  const Trajectory ours = trajectory_of(question.condition, 0, 0, question.periods);
  EXPECT_EQ(expected.ending, "reached_horizon");
  EXPECT_EQ(ours.termination, Termination::reached_horizon);
  EXPECT_LT(ours.events.size(), 500U);
}

}  // namespace
}  // namespace rocking::differential
