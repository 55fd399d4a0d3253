// What the fuzz test has found about squat blocks, in its smallest scene (lib/docs/differential.md).

#include <gtest/gtest.h>

#include "differential/account.hpp"
#include "differential/peer/block.hpp"
#include "differential/random_scene.hpp"

namespace rocking::differential {
namespace {

// With delta < 0 a block comes back over the edge it came from, in ever lower hops. While the base pushes it over the
// other edge it cannot rest: it comes down, after finite time, and leaves at once.
TEST(HopsOverOneEdge, EndInALiftOverTheOther) {
  Question question{.condition = {}, .seed = 0, .realisation = 0, .periods = 3};
  experiment::Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = 1.2};
  scene.excitation = experiment::Harmonic{.amplitude = 2.0, .frequency_ratio = 10.0, .phase = 0.0};
  scene.restitution = 0.7;
  const peer::Story expected = peer::story_of(peer_scene(question), question.periods);
  const experiment::Trajectory ours = experiment::trajectory_of(question.condition, 0, 0, question.periods);
  EXPECT_EQ(expected.ending, "reached_horizon");
  EXPECT_EQ(ours.termination, experiment::Termination::reached_horizon);
  EXPECT_LT(ours.events.size(), 500U);
}

}  // namespace
}  // namespace rocking::differential
