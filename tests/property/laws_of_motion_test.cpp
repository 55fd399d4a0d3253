// What holds on every motion: the balance of energy, the cone of friction, contact. Random blocks, bases and starts; a
// failing scene is known by its number.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/dynamics/forces.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"
#include "support/walk.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using support::WalkNode;
using support::WalkPiece;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

struct Scene {
  Stage stage;
  ScriptedCoefficients coefficients;

  [[nodiscard]] double alpha(double tau) const { return stage.base_acceleration(coefficients.amplitude_value, tau); }
};

/// From slender to square, from weak to strong shaking, from ice to rubber; static friction redrawn at stops.
Scene random_scene(std::uint64_t number) {
  SplitMix draw(number);
  Scene scene;
  scene.stage.block.height = std::exp2(draw.uniform(0.0, 3.5));
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
  scene.coefficients.restitutions = {draw.below(2) == 0 ? 0.0 : draw.uniform(-0.9, 0.3)};
  if (draw.below(3) == 0) return scene;
  scene.stage.start.tilt = draw.uniform(-0.8, 0.8) * psi;
  scene.stage.start.tilt_rate = draw.uniform(-0.8, 0.8) * psi;
  if (scene.coefficients.has_friction() && draw.below(2) == 0) scene.stage.start.slip_rate = draw.uniform(-0.3, 0.3);
  return scene;
}

/// Ten periods take a few hundred pieces; a chatter, a few hundred more.
constexpr int most_pieces = 5'000;

/// Calls visit(scene, run, piece) for each smooth piece of the first ten periods of each of many scenes. The numbers of
/// the scenes that did not get there.
template <class Visit>
std::vector<std::uint64_t> on_every_motion(Visit&& visit) {
  std::vector<std::uint64_t> stuck;
  for (std::uint64_t number = 0; number < 1'500; ++number) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, "scene " + std::to_string(number));
    const Scene scene = random_scene(number);
    ScriptedRun run(scene.stage, scene.coefficients);
    const double end = 10.0 * scene.stage.period_length();
    const bool done = support::walk(run, end, most_pieces, [&](const WalkPiece& piece) { visit(scene, run, piece); });
    if (!done) stuck.push_back(number);
    if (testing::Test::HasFailure()) break;
  }
  return stuck;
}

double edge_angle_of(const State& state, const Scene& scene) {
  return scene.stage.geometry().shape_angle - std::abs(state.tilt);
}

/// Energy over m R^2 p^2 in the frame of the base: the centre of mass moves at (V - w cos(phi), S w sin(phi)).
double energy_of(const State& state, const Scene& scene) {
  const double phi = edge_angle_of(state, scene);
  const double x = state.slip_rate - state.tilt_rate * std::cos(phi);
  const double y = state.tilt_rate * std::sin(phi);
  return 0.5 * (x * x + y * y + state.tilt_rate * state.tilt_rate / 3.0) + 4.0 / 3.0 * std::cos(phi);
}

/// N of a slipping block: 4/3 in full contact, J (G - w^2 cos(phi))/D over an edge.
double slipping_normal(const State& state, const Scene& scene, double mu_k) {
  if (state.contact == ContactState::slide) return 4.0 / 3.0;
  const double phi = edge_angle_of(state, scene);
  const double q = state.side * std::sin(phi) + state.slip_direction * mu_k * std::cos(phi);
  const double determinant = 1.0 / 3.0 + state.side * std::sin(phi) * q;
  return (4.0 / 3.0 - state.tilt_rate * state.tilt_rate * std::cos(phi)) / (3.0 * determinant);
}

bool slips(const State& state) {
  return state.contact == ContactState::slide || state.contact == ContactState::rock_slide;
}

bool rocks(const State& state) {
  return state.contact == ContactState::rock || state.contact == ContactState::rock_slide;
}

TEST(Motion, NeverStandsStillInTime) {
  const auto stuck = on_every_motion([](const Scene&, const ScriptedRun&, const WalkPiece&) {});
  EXPECT_THAT(stuck, testing::IsEmpty()) << "these scenes take more than " << most_pieces << " steps for ten periods";
}

// dE = -(4/3) alpha (V - w cos(phi)) - s mu_k N V: the work of the base and of friction. The step's last terms are below
// 1e-13, so that a piece is off by no more than a few of them, times rates of order one; Gauss's formula adds nothing.
TEST(Energy, ChangesByTheWorkOfBaseAndFriction) {
  on_every_motion([](const Scene& scene, const ScriptedRun&, const WalkPiece& piece) {
    double work = 0.0;
    for (const WalkNode& node : piece.nodes) {
      const State& state = node.state;
      const double x = state.slip_rate - state.tilt_rate * std::cos(edge_angle_of(state, scene));
      double power = -4.0 / 3.0 * scene.alpha(node.tau) * x;
      if (slips(state)) {
        const double mu_k = piece.kinetic_friction;
        power -= state.slip_direction * mu_k * slipping_normal(state, scene, mu_k) * state.slip_rate;
      }
      work += node.weight * power;
    }
    const double change = energy_of(piece.end, scene) - energy_of(piece.start, scene);
    ASSERT_NEAR(change, work, 2e-12 * (1.0 + energy_of(piece.start, scene)))
        << "from tau = " << piece.start_tau << " to " << piece.end_tau << " in " << to_string(piece.start.contact);
  });
}

// Only impacts take energy at an instant, and none gives any (e <= 1/3 here). What a chatter drops is below its tolerance.
TEST(Energy, JumpsOnlyDownAndOnlyInImpacts) {
  on_every_motion([](const Scene& scene, const ScriptedRun& run, const WalkPiece& piece) {
    bool lands = false;
    for (std::size_t k = piece.first_event; k < run.log.events.size(); ++k) {
      const EventKind kind = run.log.events[k].kind;
      lands = lands || kind == EventKind::impact_stick || kind == EventKind::impact_slip;
    }
    const double jump = energy_of(piece.after, scene) - energy_of(piece.end, scene);
    // What a root leaves of theta and V is set to 0; a root is as good as the time, 2^-49 T.
    const double rounding = 1e-12 * (1.0 + energy_of(piece.end, scene));
    ASSERT_LE(jump, rounding) << "at tau = " << piece.end_tau;
    ASSERT_TRUE(lands || jump >= -rounding) << "at tau = " << piece.end_tau << " by " << jump;
  });
}

TEST(Friction, OfARockingBlockStaysWithinItsConeWhileItPressesOnTheBase) {
  on_every_motion([](const Scene& scene, const ScriptedRun&, const WalkPiece& piece) {
    if (piece.start.contact != ContactState::rock || piece.end_tau == piece.start_tau) return;
    for (const WalkNode& node : piece.nodes) {
      const Forces forces = rocking_forces(node.state, scene.alpha(node.tau), 1.0, scene.stage.geometry());
      if (forces.normal <= 0.0) continue;
      ASSERT_LE(std::abs(forces.friction), piece.static_friction * forces.normal + 1e-11) << "at tau = " << node.tau;
    }
  });
}

TEST(Friction, OpposesTheSlip) {
  on_every_motion([](const Scene&, const ScriptedRun&, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      if (!slips(node.state)) {
        ASSERT_EQ(node.state.slip_rate, 0.0) << "at tau = " << node.tau;
      } else {
        ASSERT_GE(node.state.slip_rate * node.state.slip_direction, -1e-15) << "at tau = " << node.tau;
      }
    }
  });
}

TEST(FullContact, HoldsOnlyWithinItsThresholds) {
  on_every_motion([](const Scene& scene, const ScriptedRun&, const WalkPiece& piece) {
    const double tangent = scene.stage.geometry().tangent;
    for (const WalkNode& node : piece.nodes) {
      if (rocks(node.state)) continue;
      ASSERT_EQ(node.state.tilt, 0.0);
      ASSERT_EQ(node.state.tilt_rate, 0.0);
      if (node.state.contact == ContactState::rest) {
        ASSERT_LE(std::abs(scene.alpha(node.tau)), std::min(tangent, piece.static_friction) + 1e-14);
      } else {
        ASSERT_LE(piece.kinetic_friction, tangent) << "it would tip, tau = " << node.tau;
      }
    }
  });
}

TEST(Rocking, StaysOverItsEdge) {
  on_every_motion([](const Scene&, const ScriptedRun&, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      ASSERT_TRUE(!rocks(node.state) || node.state.tilt * node.state.side >= -1e-15) << "at tau = " << node.tau;
    }
  });
}

TEST(NormalForce, IsPositiveOrItsLossIsReported) {
  on_every_motion([](const Scene& scene, const ScriptedRun& run, const WalkPiece& piece) {
    for (const WalkNode& node : piece.nodes) {
      if (!rocks(node.state)) continue;
      const double normal = slips(node.state)
                                ? slipping_normal(node.state, scene, piece.kinetic_friction)
                                : rocking_forces(node.state, scene.alpha(node.tau), 1.0, scene.stage.geometry()).normal;
      if (normal >= -1e-12) continue;
      ASSERT_GT(run.motion.losses_of_contact(), 0U) << "at tau = " << node.tau;
      ASSERT_LE(run.motion.first_loss_of_contact(), node.tau + 1e-12);
    }
  });
}

// X is the integral of V, across events too.
TEST(Slip, IsTheIntegralOfItsRate) {
  on_every_motion([](const Scene&, const ScriptedRun&, const WalkPiece& piece) {
    double slip = piece.start.slip;
    for (const WalkNode& node : piece.nodes) slip += node.weight * node.state.slip_rate;
    ASSERT_NEAR(piece.end.slip, slip, 1e-13 * (1.0 + std::abs(slip)));
    ASSERT_EQ(piece.after.slip, piece.end.slip) << "nothing displaces the edge at an instant";
  });
}

}  // namespace
}  // namespace rocking::dynamics
