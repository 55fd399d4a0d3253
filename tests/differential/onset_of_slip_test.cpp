// The smallest scenes of what the fuzz test has found, so that it stays found (lib/docs/differential.md).

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
  experiment::Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = start.height};
  scene.excitation =
      experiment::Harmonic{.amplitude = start.amplitude, .frequency_ratio = start.frequency, .phase = 0.0};
  scene.friction = experiment::Friction{.static_coefficient = start.friction, .kinetic_coefficient = start.friction};
  scene.initial.tilt = 0.3;
  return question;
}

void expect_agreement(const Question& question) {
  const Comparison comparison = compare(question, question, 1.0);
  EXPECT_EQ(comparison.outcome, Outcome::agreed)
      << "entry " << comparison.entries << ", difference " << comparison.difference;
}

// With mu_s = mu_k the onset of slip has V' = 0 only where the equations with and without slip are of one inertia.
TEST(OnsetOfSlip, MakesSlipAccelerateAtOnceUnderTheInertiaOfTheEdge) {
  Question question = question_of({.height = 4.0, .friction = 0.2, .amplitude = 2.0, .frequency = 5.0});
  question.condition.scene.slide_inertia = dynamics::SlideInertia::edge;
  expect_agreement(question);
}

// Off the ground friction is not tested: when N rises through 0, more of it may be asked for than there is. That onset
// is no root of the friction limit, and V' is not 0.
TEST(OnsetOfSlip, MakesSlipAccelerateAtOnceWhereTheBlockComesBackToTheGround) {
  expect_agreement(question_of({.height = 1.5, .friction = 0.45, .amplitude = 9.0, .frequency = 3.0}));
}

}  // namespace
}  // namespace rocking::differential
