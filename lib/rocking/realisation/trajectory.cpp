#include "rocking/realisation/trajectory.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>

#include "rocking/base/error.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/setting.hpp"
#include "rocking/realisation/forwarded_motion.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// Kinetic energy relative to the base plus the potential energy of the weight, over m R^2 p^2. By Koenig's theorem with
/// the inertia J about the centre of mass and the lever c of the edge: (J + r^2) w^2/2 + V^2/2 - V w c + G c, which is
/// (2/3) w^2 + V^2/2 - V w cos(phi) + (4/3) cos(phi) for a rectangle.
[[nodiscard]] inline double energy_of(const dynamics::State& state, const dynamics::Setting& setting) {
  const dynamics::AnyConstants constants = equation_constants(setting, state.side);
  const double cosine = edge_angle(state, constants).cosine;
  const double w = state.tilt_rate;
  const double v = state.slip_rate;
  return 1.0 / setting.block.edge(state.side).impact_gain * w * w + 0.5 * v * v - v * w * cosine +
         constants.load * cosine;
}

/// A motion with the same bits as `Motion` that also keeps its energy balance. The work of each step is integrated by
/// Gauss's rule with 15 points, from the polynomials of the step.
template <class Motion>
class AccountedMotion : public Motion {
 public:
  explicit AccountedMotion(Motion motion) : Motion(std::move(motion)) {
    account_.at_start = account_.at_end = energy_of(this->state(), this->setting());
  }

  [[nodiscard]] const EnergyAccount& account() const { return account_; }
  /// Sides of the block at the largest abs(Theta) and abs(Theta').
  [[nodiscard]] const std::array<double, 2>& peak_sides() const { return peak_sides_; }

  void strobe(double x) {
    Motion::strobe(x);
    if (this->ended()) end_step(x);  // at the horizon: the rest of the step is not executed
  }

  void move(double x) {
    end_step(x);
    const double side = this->state().side;
    Motion::move(x);
    note_peaks(side);
  }

  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    const double side = this->state().side;
    Motion::reset(fired, at_breakpoint);
    note_peaks(side);
    const double after = energy_of(this->state(), this->setting());
    (after < account_.at_end ? account_.lost_in_impacts : account_.gained_in_impacts) +=
        std::abs(after - account_.at_end);
    account_.at_end = after;
  }

 private:
  void note_peaks(double side) {
    if (this->peaks().tilt > peak_tilt_) peak_sides_[0] = side;
    if (this->peaks().tilt_rate > peak_tilt_rate_) peak_sides_[1] = side;
    peak_tilt_ = this->peaks().tilt;
    peak_tilt_rate_ = this->peaks().tilt_rate;
  }

  void end_step(double x) {
    using Quadrature = boost::math::quadrature::gauss<double, 15>;
    if (x > 0.0) {
      account_.base_work += Quadrature::integrate([this](double t) { return base_power(t); }, 0.0, x);
      if (this->slips())
        account_.friction_work += Quadrature::integrate([this](double t) { return friction_power(t); }, 0.0, x);
    }
    account_.at_end = energy_of(this->state_at(x), this->setting());
  }

  [[nodiscard]] double base_power(double x) const {
    const dynamics::State state = this->state_at(x);
    const auto [alpha, weight] = this->base_at(x);
    const dynamics::AnyConstants constants = equation_constants(this->setting(), state.side);
    const auto [sine, cosine] = edge_angle(state, constants);
    const double along = state.slip_rate - state.tilt_rate * cosine;
    const double upwards = state.side * state.tilt_rate * sine;
    return -constants.load * (alpha * along + (weight - 1.0) * upwards);
  }

  [[nodiscard]] double friction_power(double x) const {
    const dynamics::State state = this->state_at(x);
    const dynamics::BaseMotion base = this->base_at(x);
    const dynamics::AnyConstants constants = equation_constants(this->setting(), state.side);
    double normal = constants.load * base.weight;
    if (state.contact == dynamics::ContactState::rock_slide) {
      const auto [sine, cosine] = edge_angle(state, constants);
      const auto rates = slipping_rates(state, base, this->kinetic_friction(), constants);
      normal += state.side * rates.tilt_acceleration * sine - state.tilt_rate * state.tilt_rate * cosine;
    }
    return -state.slip_direction * this->kinetic_friction() * normal * state.slip_rate;
  }

  EnergyAccount account_;
  double peak_tilt_ = 0.0;
  double peak_tilt_rate_ = 0.0;
  std::array<double, 2> peak_sides_{1.0, 1.0};
};

/// Records strobe points and events, in the units of files.
class Recorder final : public dynamics::Observer {
 public:
  Recorder(const dynamics::Geometry& block, base::StopRequest stop) : block_(block), stop_(stop) {}

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    const double psi = block_.tilt_unit(state.tilt, state.tilt_rate);
    trajectory.events.push_back({.tau = tau,
                                 .kind = kind,
                                 .tilt = state.tilt / psi,
                                 .tilt_rate = state.tilt_rate / psi,
                                 .slip = state.slip,
                                 .slip_rate = state.slip_rate});
  }

  void strobe(const dynamics::State& state) override {
    stop_.check();  // a block at rest passes many periods in one step
    const double psi = block_.tilt_unit(state.tilt, state.tilt_rate);
    trajectory.strobe.push_back({.period = static_cast<std::int64_t>(trajectory.strobe.size()) + 1,
                                 .tilt = state.tilt / psi,
                                 .tilt_rate = state.tilt_rate / psi,
                                 .slip = state.slip,
                                 .slip_rate = state.slip_rate,
                                 .contact = state.contact});
  }

  Trajectory trajectory;

 private:
  dynamics::Geometry block_;
  base::StopRequest stop_;
};

template <class Motion>
void advance(Motion& motion, base::StopRequest stop) {
  for (integrate::LoopCounts counts; !motion.ended(); integrate::step(motion, counts)) stop.check();
}

/// Runs the motion to its end and samples it.
template <class Motion>
void run(Motion& motion, const Beginning& beginning, const TrajectoryExtent& extent,
         std::vector<HistoryPoint>& history) {
  if (extent.samples_per_period == 0) {
    advance(motion, extent.stop);
    return;
  }
  SampledMotion<Motion> sampled(motion, extent.samples_per_period, beginning.clock.period_length(), history);
  advance(sampled, extent.stop);
}

std::vector<HistorySample> in_units_of_files(const std::vector<HistoryPoint>& points, const dynamics::Geometry& block) {
  std::vector<HistorySample> history;
  history.reserve(points.size());
  for (const auto& [tau, state, base_acceleration] : points) {
    const double psi = block.tilt_unit(state.tilt, state.tilt_rate);
    history.push_back({.tau = tau,
                       .tilt = state.tilt / psi,
                       .tilt_rate = state.tilt_rate / psi,
                       .slip = state.slip,
                       .slip_rate = state.slip_rate,
                       .contact = state.contact,
                       .base_acceleration = base_acceleration});
  }
  return history;
}

}  // namespace

Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                         const TrajectoryExtent& extent) {
  check_condition(condition);
  return trajectory_of_unchecked(condition, seed, realisation, extent);
}

Trajectory trajectory_of_unchecked(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                   const TrajectoryExtent& extent) {
  ROCKING_EXPECT(extent.periods > 0);
  const random::Draws draws(seed_of(condition, seed), realisation);
  const Start start = start_of(condition.scene, draws);
  Recorder recorder(start.geometry, extent.stop);
  std::vector<HistoryPoint> history;
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, extent.periods);
  AccountedMotion motion(motion_of(condition.scene, beginning, recorder));
  run(motion, beginning, extent, history);
  Trajectory& trajectory = recorder.trajectory;
  trajectory.block = start.block;
  trajectory.outline = outline_of(start.scene.block);
  trajectory.period_length = beginning.clock.period_length();
  trajectory.termination = motion.termination().value_or(Termination::stopped);
  trajectory.losses_of_contact = motion.losses_of_contact();
  if (motion.losses_of_contact() > 0) trajectory.first_loss_of_contact = motion.first_loss_of_contact();
  trajectory.losses_before_fall = motion.losses_before_fall();
  trajectory.peaks = peaks_of(motion, beginning.setting.block);
  trajectory.peak_sides = motion.peak_sides();
  trajectory.contradictions = motion.contradictions();
  trajectory.energy = motion.account();
  trajectory.samples_per_period = extent.samples_per_period;
  trajectory.history = in_units_of_files(history, start.geometry);
  return std::move(recorder.trajectory);
}

}  // namespace rocking
