#include "benchmarks/odeint_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/numeric/odeint.hpp>

#include "differential/peer/impact.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::benchmarks {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::array<double, 4>;  // theta, w, X, V
using Method = odeint::runge_kutta_dopri5<State>;
using Stepper = odeint::result_of::make_dense_output<Method>::type;

double sign_of(double value) { return value < 0.0 ? -1.0 : 1.0; }

/// Positive while the equations hold.
struct Guards {
  double ground = 1.0;
  double friction = 1.0;  ///< slip rate in the direction of slip, or what static friction has left

  [[nodiscard]] double least() const { return std::min(ground, friction); }
};

/// Equations of a block on one edge, lib/docs/model.md, sections 2 and 3.
struct Equations {
  double psi, acceleration, frequency;  ///< of the base, over g
  bool can_slip;
  double side = 1.0;
  bool slips = false;
  double direction = 1.0;
  double mu_s = 0.0, mu_k = 0.0;
  // At the last call. The last stage of the method is the end of its step, so that testing guards costs nothing there.
  Guards guards = {};
  double force = 0.0;  ///< of static friction

  void operator()(const State& y, State& rates, double tau) {
    const double alpha = acceleration * std::sin(frequency * tau);
    const double angle = psi - side * y[0];
    const double sine = side * std::sin(angle);
    const double cosine = std::cos(angle);
    const double square = y[1] * y[1];
    guards.ground = side * y[0];
    if (slips) {
      const double q = sine + direction * mu_k * cosine;
      const double w_dot = -(4.0 / 3.0 - square * cosine) * q / (1.0 / 3.0 + sine * q);
      const double normal = 4.0 / 3.0 + w_dot * sine - square * cosine;
      const double v_dot = w_dot * cosine + square * sine - direction * mu_k * normal - 4.0 / 3.0 * alpha;
      rates = {y[1], w_dot, y[3], v_dot};
      guards.friction = direction * y[3];
      return;
    }
    const double w_dot = alpha * cosine - sine;
    rates = {y[1], w_dot, 0.0, 0.0};
    if (!can_slip) return;
    const double normal = 4.0 / 3.0 + w_dot * sine - square * cosine;
    force = 4.0 / 3.0 * alpha - w_dot * cosine - square * sine;
    guards.friction = mu_s * normal - std::abs(force);
  }
};

class Block {
 public:
  Block(const peer::Scene& scene, double tolerance)
      : scene_(scene),
        body_(peer::body_of(scene)),
        equations_{body_.unit(), scene.amplitude * body_.unit(), scene.frequency, scene.friction.has_value()},
        period_(2.0 * std::numbers::pi / scene.frequency),
        pitch_(period_ / scene.refreshes_per_period),
        draws_(scene.seed, scene.realisation),
        normals_(static_cast<std::size_t>(scene.refreshes_per_period)),
        stepper_(odeint::make_dense_output(tolerance, tolerance, period_ / 16.0, Method())),
        step_(1e-3 * period_),
        y_{scene.tilt * body_.unit(), scene.tilt_rate * body_.unit(), 0.0, scene.slip_rate} {
    equations_.side = sign_of(y_[0]);
    draw_static();
    stick_or_slip();
  }

  std::optional<peer::Posture> follow(std::int64_t count) {
    const double end = static_cast<double>(count) * period_;
    while (tau_ < end) {
      advance(redraws() && equations_.slips ? std::min(end, static_cast<double>(interval_ + 1) * pitch_) : end);
      if (std::abs(y_[0]) > std::numbers::pi / 2.0) return std::nullopt;
    }
    return peer::Posture{y_[0] / body_.unit(), y_[1] / body_.unit(), y_[2], y_[3]};
  }

 private:
  [[nodiscard]] bool redraws() const { return scene_.sigmas.sliding > 0.0; }

  /// Takes the coefficient of kinetic friction in force.
  void look_up() {
    if (!scene_.friction) return;
    double mu_k = scene_.friction->sliding;
    if (redraws()) {
      const std::int64_t count = scene_.refreshes_per_period;
      interval_ = static_cast<std::int64_t>(std::floor(tau_ / pitch_ + 1e-9));
      if (interval_ / count != drawn_period_) {
        drawn_period_ = interval_ / count;
        draws_.standard_normals(random::Source::kinetic_friction, static_cast<std::uint64_t>(drawn_period_ * count),
                                normals_);
      }
      mu_k += scene_.sigmas.sliding * normals_[static_cast<std::size_t>(interval_ % count)];
    }
    equations_.mu_k = std::clamp(mu_k, 0.0, equations_.mu_s);
  }

  void draw_static() {
    if (!scene_.friction) return;
    equations_.mu_s = scene_.friction->at_rest;
    if (scene_.sigmas.at_rest > 0.0) {
      equations_.mu_s += scene_.sigmas.at_rest * draws_.standard_normal(random::Source::static_friction, stops_++);
    }
    equations_.mu_s = std::max(0.0, equations_.mu_s);
    look_up();
  }

  [[nodiscard]] State rates(const State& y, double tau) {
    State rates{};
    equations_(y, rates, tau);
    return rates;
  }

  void slip() {
    equations_.slips = true;
    equations_.direction = -sign_of(equations_.force);
  }

  void stick_or_slip() {
    equations_.slips = false;
    (void)rates(y_, tau_);
    if (equations_.guards.friction < 0.0) slip();
  }

  /// To `stop`, or to the first event before it and beyond it.
  void advance(double stop) {
    bool begins = true;
    while (stop - tau_ > 1e-13) {
      const double rest = stop - tau_;
      if (begins || step_ > 0.5 * rest)
        stepper_.initialize(y_, tau_, step_ > rest ? rest : std::min(step_, 0.5 * rest));
      begins = false;
      stepper_.do_step(std::ref(equations_));
      if (equations_.guards.least() < 0.0) return happen();
      y_ = stepper_.current_state();
      tau_ = stepper_.current_time();
      step_ = stepper_.current_time_step();
    }
    tau_ = stop;
    look_up();
  }

  /// Goes to the event in the last step, and through it.
  void happen() {
    const double start = stepper_.previous_time();
    double low = start;
    tau_ = stepper_.current_time();
    const double resolution = 1e-3 * (tau_ - start);  // Newton's method does the rest
    while (tau_ - low > resolution) {
      const double middle = 0.5 * (low + tau_);
      stepper_.calc_state(middle, y_);
      (void)rates(y_, middle);
      (equations_.guards.least() < 0.0 ? tau_ : low) = middle;
    }
    stepper_.calc_state(tau_, y_);
    (void)rates(y_, tau_);
    const auto guard = equations_.guards.ground < equations_.guards.friction ? &Guards::ground : &Guards::friction;
    // The dense output has a lower order than the method, which errors would show.
    for (int corrections = 0;; ++corrections) {
      Method().do_step(std::ref(equations_), stepper_.previous_state(), start, y_, tau_ - start);
      const double value = equations_.guards.*guard;
      if (corrections == 2) break;
      constexpr double later = 1e-7;
      State there = rates(y_, tau_);
      for (std::size_t i = 0; i < there.size(); ++i) there[i] = y_[i] + later * there[i];
      (void)rates(there, tau_ + later);
      tau_ -= later * value / (equations_.guards.*guard - value);
    }
    look_up();
    if (guard == &Guards::ground) return land();
    if (!equations_.slips) return slip();
    y_[3] = 0.0;
    draw_static();
    stick_or_slip();
  }

  void land() {
    std::optional<peer::Friction> friction;
    if (scene_.friction) friction = {equations_.mu_s, equations_.mu_k};
    const peer::Rebound after =
        peer::land(body_, {y_[1], y_[3], scene_.restitution, friction, scene_.signed_impact_rule});
    if (!(std::abs(after.w) > 1e-9)) throw std::runtime_error("a block came to rest");
    const bool stops = y_[3] != 0.0 && after.v == 0.0;
    y_ = {0.0, after.w, y_[2], after.v};
    equations_.side = sign_of(after.w);
    if (stops) draw_static();
    if (after.v == 0.0) return stick_or_slip();
    equations_.slips = true;
    equations_.direction = sign_of(after.v);
  }

  const peer::Scene& scene_;
  peer::Body body_;
  Equations equations_;
  double period_;
  double pitch_;  ///< of the grid on which kinetic friction is redrawn
  random::Draws draws_;
  std::vector<double> normals_;
  std::int64_t drawn_period_ = -1;
  std::int64_t interval_ = 0;
  std::uint64_t stops_ = 0;
  Stepper stepper_;
  double step_;
  double tau_ = 0.0;
  State y_;
};

}  // namespace

std::optional<peer::Posture> follow_by_odeint(const peer::Scene& scene, std::int64_t period_count, double tolerance) {
  return Block(scene, tolerance).follow(period_count);
}

}  // namespace rocking::benchmarks
