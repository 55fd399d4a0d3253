#include "differential/peer/mechanics.hpp"

#include <cmath>

namespace rocking::peer {
namespace {

/// Newton's laws normal to and along the base, and Euler's law about the centre of mass, for a trial value of w'.
struct Trial {
  double normal;
  double friction;
  double v_dot;
  double moment_left_over;
};

/// Position of the centre of mass relative to the edge, and motion of the block.
struct Pose {
  double across;
  double up;
  double square;  ///< w^2
  double weight;  ///< g/(R p^2)
};

/// All four are affine in w'. `law(normal, force_of_sticking)` is the law of friction.
template <class FrictionLaw>
Trial attempt(double w_dot, double inertia, const Pose& pose, const Shaking& base, FrictionLaw law) {
  const auto [across, up, square, weight] = pose;
  Trial trial{};
  trial.normal = weight * (1.0 + base.vertical) + w_dot * across - square * up;
  const double without_slip = weight * base.alpha - w_dot * up - square * across;
  trial.friction = law(trial.normal, without_slip);
  trial.v_dot = trial.friction - without_slip;
  trial.moment_left_over = inertia * w_dot + across * trial.normal - up * trial.friction;
  return trial;
}

template <class FrictionLaw>
Balance balance_under(double inertia, const Body& body, const Stance& stance, const Shaking& base, FrictionLaw law) {
  // The centre of mass of the untilted block, turned about the edge.
  const double x = stance.side * body.edge(stance.side);
  const double sine = std::sin(stance.theta);
  const double cosine = std::cos(stance.theta);
  const Pose pose{x * cosine - body.height * sine, x * sine + body.height * cosine, stance.w * stance.w, body.weight};
  const double at_zero = attempt(0.0, inertia, pose, base, law).moment_left_over;
  const double slope = attempt(1.0, inertia, pose, base, law).moment_left_over - at_zero;
  const double w_dot = -at_zero / slope;
  const Trial found = attempt(w_dot, inertia, pose, base, law);
  return {w_dot, found.v_dot, found.normal, found.friction, slope};
}

}  // namespace

Body body_of(const Scene& scene) {
  const auto& [left, right] = scene.edges;
  const double unit = std::hypot(0.5 * (left + right), scene.height);
  const double inertia = scene.gyration_squared / (unit * unit);
  return {.edges = {left / unit, right / unit},
          .height = scene.height / unit,
          .inertia = inertia,
          .slip_inertia = scene.edge_inertia ? 1.0 + inertia : inertia,
          .weight = 1.0 + inertia};
}

Balance sticking(const Body& body, const Stance& stance, const Shaking& base) {
  return balance_under(body.inertia, body, stance, base, [](double, double without_slip) { return without_slip; });
}

Balance sliding(const Body& body, const Stance& stance, const Shaking& base, double direction, double mu_k) {
  return balance_under(body.slip_inertia, body, stance, base,
                       [=](double normal, double) { return -direction * mu_k * normal; });
}

}  // namespace rocking::peer
