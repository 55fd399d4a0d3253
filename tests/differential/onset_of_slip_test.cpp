// The smallest scenes of what the fuzz test found, as regression tests (reports/evidence/differential.md).

#include <gtest/gtest.h>

#include "differential/compare.hpp"

namespace rocking::differential {
namespace {

struct Start {
  double height;     ///< over a width of 1 m
  double friction;   ///< mu_s = mu_k
  double amplitude;  ///< A_h
  double frequency;  ///< Omega_h
};

/// One period from Theta = 0.3.
Question question_of(const Start& start) {
  Question question{.condition = {}, .seed = 0, .realisation = 0, .periods = 1};
  Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = start.height};
  scene.excitation = Harmonic{.amplitude = start.amplitude, .frequency_ratio = start.frequency, .phase = 0.0};
  scene.friction = Friction{.static_coefficient = start.friction, .kinetic_coefficient = start.friction};
  scene.initial.tilt = 0.3;
  return question;
}

void expect_agreement(const Question& question) {
  const Comparison comparison = compare(question, question, 1.0);
  EXPECT_EQ(comparison.outcome, Outcome::agreed)
      << "entry " << comparison.entries << ", difference " << comparison.difference;
}

// With mu_s = mu_k, V' = 0 at the onset of slip only if the equations with and without slip have the same inertia.
TEST(OnsetOfSlip, MakesSlipAccelerateAtOnceUnderTheInertiaOfTheEdge) {
  Question question = question_of({.height = 4.0, .friction = 0.2, .amplitude = 2.0, .frequency = 5.0});
  question.condition.scene.slide_inertia = dynamics::SlideInertia::edge;
  expect_agreement(question);
}

// While the block is off the ground friction is not tested. When N rises through 0, the required friction may exceed
// the available one. That onset is no root of the friction limit, and V' is not 0.
TEST(OnsetOfSlip, MakesSlipAccelerateAtOnceWhereTheBlockComesBackToTheGround) {
  expect_agreement(question_of({.height = 1.5, .friction = 0.45, .amplitude = 9.0, .frequency = 3.0}));
}

}  // namespace
}  // namespace rocking::differential
