// Laws that hold for every motion: the balance of energy, the friction limit, contact. Blocks, bases and initial states
// are random; a failing scene is identified by its number.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "property/mechanics.hpp"
#include "property/scene.hpp"
#include "rocking/dynamics/forces.hpp"
#include "support/split_mix.hpp"
#include "support/walk.hpp"

namespace rocking::dynamics {
namespace {

using property::Base;
using property::energy_of;
using property::load_of;
using property::random_mass;
using property::random_record;
using property::rocks;
using property::Scene;
using property::slipping_normal;
using property::slips;
using property::tangent_of;
using property::velocity_of;
using property::with_simulation;
using support::SplitMix;
using support::WalkNode;
using support::WalkPiece;

constexpr std::uint64_t scenes_of_a_form = 1'800;

/// Slender to squat blocks, rectangles and then blocks with their mass off the middle, weak to strong excitation, small to large friction. Static friction is redrawn at stops.
/// The base motion is in turn harmonic, recorded, and recorded with a vertical motion.
Scene random_scene(std::uint64_t number) {
  SplitMix draw(number);
  Scene scene;
  scene.stage.block.height = std::exp2(draw.uniform(-0.5, 3.5));
  if (number >= scenes_of_a_form) scene.stage.block.mass = random_mass(draw);
  scene.stage.frequency = draw.uniform(2.0, 12.0);
  scene.stage.phase = draw.uniform(0.0, 2.0 * std::numbers::pi);
  scene.stage.periods = 1'000'000'000;
  const double psi = scene.stage.geometry().shape_angle;
  scene.coefficients.amplitude_value = draw.uniform(0.5, 8.0) * (draw.below(2) == 0 ? -1.0 : 1.0);
  if (draw.below(4) != 0) {
    const double mu_s = draw.uniform(0.05, 0.9);
    scene.coefficients.statics = {mu_s, mu_s * draw.uniform(0.5, 1.5), mu_s * draw.uniform(0.5, 1.5), mu_s};
    scene.coefficients.kinetics = {mu_s * (draw.below(3) == 0 ? 2.0 : draw.uniform(0.3, 1.0))};
  }
  // Above 1/3 an impact of a squat block may gain energy (lib/docs/model.md, section 4).
  scene.coefficients.restitutions = {draw.below(2) == 0 ? 0.0 : draw.uniform(-0.9, psi < 0.62 ? 1.0 : 1.0 / 3.0)};
  scene.base = static_cast<Base>(number % 3);
  if (scene.base != Base::harmonic) scene.knots = random_record(scene.stage, 11.0, draw);
  if (draw.below(3) == 0) return scene;
  scene.stage.start.tilt = draw.uniform(-0.8, 0.8) * psi;
  scene.stage.start.tilt_rate = draw.uniform(-0.8, 0.8) * psi;
  if (scene.coefficients.has_friction() && draw.below(2) == 0) scene.stage.start.slip_rate = draw.uniform(-0.3, 0.3);
  return scene;
}

/// Ten periods consist of a few hundred pieces; a chatter adds a few hundred.
constexpr int most_pieces = 5'000;

/// Calls visit(scene, run, piece) for each smooth piece of the first ten periods of each of many scenes. Returns the
/// numbers of the scenes that did not finish.
template <class Visit>
std::vector<std::uint64_t> on_every_motion(Visit&& visit, double tolerance = 1e-13) {
  std::vector<std::uint64_t> stuck;
  for (std::uint64_t number = 0; number < 2 * scenes_of_a_form; ++number) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, "scene " + std::to_string(number));
    Scene scene = random_scene(number);
    scene.stage.tolerance = tolerance;
    const double end = 10.0 * scene.stage.period_length();
    with_simulation(scene, [&](auto& run) {
      const bool done = support::walk(run, end, most_pieces, [&](const WalkPiece& piece) { visit(scene, run, piece); });
      if (!done) stuck.push_back(number);
    });
    if (testing::Test::HasFailure()) break;
  }
  return stuck;
}

TEST(Motion, NeverStandsStillInTime) {
  const auto stuck = on_every_motion([](const Scene&, const auto&, const WalkPiece&) {});
  EXPECT_THAT(stuck, testing::IsEmpty()) << "these scenes take more than " << most_pieces << " steps for ten periods";
}

/// Energy that a piece gained beyond the work of the base and of friction, over 1 + its energy:
/// dE = -(1 + J) (alpha (V - w c) + alpha_v S w s) - s mu_k N V.
double unaccounted(const Scene& scene, const WalkPiece& piece) {
  double work = 0.0;
  for (const WalkNode& node : piece.nodes) {
    const State& state = node.state;
    const auto [x, y] = velocity_of(state, scene);
    const auto [alpha, weight] = scene.ground(node.tau);
    double power = -load_of(scene) * (alpha * x + (rocks(state) ? (weight - 1.0) * y : 0.0));
    if (slips(state)) {
      const double mu_k = piece.kinetic_friction;
      power -= state.slip_direction * mu_k * slipping_normal(state, scene, node.tau, mu_k) * state.slip_rate;
    }
    work += node.weight * power;
  }
  const double before = energy_of(piece.start, scene);
  return (energy_of(piece.end, scene) - before - work) / (1.0 + before);
}

// The last two terms of a step are at most the tolerance, in Theta' and in V. If the terms decrease steadily, the omitted
// ones sum to less than twice that in each rate; in the energy this is multiplied by a few momenta of order 1 + E. If two
// successive terms happen to be near a zero of a cosine, reduced to a share s, they hide an error larger by 1/s; the
// probability of this is s^2. Gauss's formula adds no error. Rounding: about a hundred times 2^-53.
class EnergyAtTolerance : public testing::TestWithParam<double> {};

TEST_P(EnergyAtTolerance, ChangesByTheWorkOfBaseAndFriction) {
  std::size_t pieces = 0;
  std::size_t beyond = 0;
  on_every_motion(
      [&](const Scene& scene, const auto&, const WalkPiece& piece) {
        const double error = std::abs(unaccounted(scene, piece));
        ++pieces;
        if (error > 20.0 * GetParam() + 2e-14) ++beyond;
        ASSERT_LE(error, 2000.0 * GetParam() + 2e-14)
            << "from tau = " << piece.start_tau << " to " << piece.end_tau << " in " << to_string(piece.start.contact);
      },
      GetParam());
  EXPECT_GT(pieces, 50'000U);
  EXPECT_LE(beyond, pieces / 10'000) << "of " << pieces;
}

INSTANTIATE_TEST_SUITE_P(All, EnergyAtTolerance, testing::Values(1e-13, 1e-11, 1e-8));

// Over whole motions, impacts counted as what they took: the errors of the pieces do not add up.
TEST(Energy, IsBalancedToTwelveDigitsAPeriod) {
  double last = 0.0;
  double sum = 0.0;
  on_every_motion([&](const Scene& scene, const auto&, const WalkPiece& piece) {
    if (piece.start_tau < last) sum = 0.0;
    last = piece.start_tau;
    sum += unaccounted(scene, piece);
    const double periods = std::max(1.0, piece.end_tau / scene.stage.period_length());
    ASSERT_LE(std::abs(sum), 1e-12 * periods) << "at tau = " << piece.end_tau;
  });
}

// Only impacts change the energy at an instant, and none increases it: e <= 1/3 here for squat blocks, and of blocks with
// their mass off the middle, impacts with e = 0 onto the other edge (lib/docs/model.md, sections 4 and 11). What the end of
// a chatter neglects is below its tolerance.
TEST(Energy, JumpsOnlyDownAndOnlyInImpacts) {
  on_every_motion([](const Scene& scene, const auto& run, const WalkPiece& piece) {
    bool lands = false;
    for (std::size_t k = piece.first_event; k < run.log.events.size(); ++k) {
      const EventKind kind = run.log.events[k].kind;
      lands = lands || kind == EventKind::impact_stick || kind == EventKind::impact_slip;
    }
    const double jump = energy_of(piece.after, scene) - energy_of(piece.end, scene);
    // At a root theta and V are set to 0; the root has the accuracy of the time, 2^-49 T.
    const double rounding = 1e-12 * (1.0 + energy_of(piece.end, scene));
    const bool may_gain =
        scene.stage.block.mass && (scene.coefficients.restitutions.at(0) != 0.0 || piece.end.side == piece.after.side);
    ASSERT_TRUE(may_gain || jump <= rounding) << jump << " at tau = " << piece.end_tau;
    ASSERT_TRUE(lands || jump >= -rounding) << "at tau = " << piece.end_tau << " by " << jump;
  });
}

TEST(Friction, OfARockingBlockStaysWithinItsConeWhileItPressesOnTheBase) {
  on_every_motion([](const Scene& scene, const auto&, const WalkPiece& piece) {
    if (piece.start.contact != ContactState::rock || piece.end_tau == piece.start_tau) return;
    for (const WalkNode& node : piece.nodes) {
      const Forces forces = sticking_forces(node.state, scene, node.tau);
      if (forces.normal <= 0.0) continue;
      ASSERT_LE(std::abs(forces.friction), piece.static_friction * forces.normal + 1e-11) << "at tau = " << node.tau;
    }
  });
}

TEST(Friction, OpposesTheSlip) {
  on_every_motion([](const Scene&, const auto&, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      if (!slips(node.state)) {
        ASSERT_EQ(node.state.slip_rate, 0.0) << "at tau = " << node.tau;
      } else {
        ASSERT_GE(node.state.slip_rate * node.state.slip_direction, -1e-15) << "at tau = " << node.tau;
      }
    }
  });
}

// By Newton's law, F is the change of the horizontal speed of the centre, V - w c, plus (1 + J) alpha. The bound
// is a thousand tolerances, since the last terms of a step can hide an omitted part, as above.
TEST(Friction, OfASlippingBlockIsItsShareOfTheNormalForceAgainstTheSlip) {
  on_every_motion([](const Scene& scene, const auto&, const WalkPiece& piece) {
    if (!slips(piece.start)) return;
    double friction = velocity_of(piece.end, scene).along - velocity_of(piece.start, scene).along;
    double normal = 0.0;
    for (const WalkNode& node : piece.nodes) {
      friction += node.weight * load_of(scene) * scene.ground(node.tau).alpha;
      normal += node.weight * slipping_normal(node.state, scene, node.tau, piece.kinetic_friction);
    }
    ASSERT_NEAR(friction, -piece.start.slip_direction * piece.kinetic_friction * normal, 1e-10 * (1.0 + normal))
        << "from tau = " << piece.start_tau << " to " << piece.end_tau;
  });
}

TEST(FullContact, HoldsOnlyWithinItsThresholds) {
  on_every_motion([](const Scene& scene, const auto&, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      if (rocks(node.state)) continue;
      ASSERT_EQ(node.state.tilt, 0.0);
      ASSERT_EQ(node.state.tilt_rate, 0.0);
      if (node.state.contact == ContactState::rest) {
        const auto [alpha, weight] = scene.ground(node.tau);
        ASSERT_LE(std::abs(alpha), std::min(tangent_of(scene, alpha), piece.static_friction) * weight + 1e-14);
      } else {
        ASSERT_LE(piece.kinetic_friction, tangent_of(scene, -node.state.slip_direction))
            << "it would tip, tau = " << node.tau;
      }
    }
  });
}

TEST(Rocking, StaysOverItsEdge) {
  on_every_motion([](const Scene&, const auto&, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      ASSERT_TRUE(!rocks(node.state) || node.state.tilt * node.state.side >= -1e-15) << "at tau = " << node.tau;
    }
  });
}

TEST(NormalForce, IsPositiveOrItsLossIsReported) {
  on_every_motion([](const Scene& scene, const auto& run, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      if (!rocks(node.state)) continue;
      const double normal = slips(node.state) ? slipping_normal(node.state, scene, node.tau, piece.kinetic_friction)
                                              : sticking_forces(node.state, scene, node.tau).normal;
      if (normal >= -1e-12) continue;
      ASSERT_GT(run.motion.losses_of_contact(), 0U) << "at tau = " << node.tau;
      ASSERT_LE(run.motion.first_loss_of_contact(), node.tau + 1e-12);
    }
  });
}

// X is the integral of V, also across events.
TEST(Slip, IsTheIntegralOfItsRate) {
  on_every_motion([](const Scene&, const auto&, const WalkPiece& piece) {
    double slip = piece.start.slip;
    for (const WalkNode& node : piece.nodes) slip += node.weight * node.state.slip_rate;
    ASSERT_NEAR(piece.end.slip, slip, 1e-13 * (1.0 + std::abs(slip)));
    ASSERT_EQ(piece.after.slip, piece.end.slip) << "nothing displaces the edge at an instant";
  });
}

}  // namespace
}  // namespace rocking::dynamics
