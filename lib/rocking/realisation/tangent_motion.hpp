#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/dynamics/saltation.hpp"
#include "rocking/dynamics/step_series.hpp"
#include "rocking/dynamics/step_variation.hpp"
#include "rocking/realisation/guard_log.hpp"

namespace rocking {

/// Instants of a motion at which its derivative does not exist.
struct NotDifferentiable {
  std::uint64_t grazings = 0;  ///< a guard was reached at a rate of 0 up to rounding; see TangentMotion
  std::uint64_t coincidences =
      0;  ///< two of impact, end of slip, onset of slip, end of a cell and breakpoint at one instant

  [[nodiscard]] bool any() const { return grazings > 0 || coincidences > 0; }
};

/// A motion with the same bits as `Motion` that also carries `count` tangent vectors: derivatives of its state with
/// respect to its initial state, in a fixed direction each. Random numbers are held: the index of a draw is a constant.
///
/// Between events a vector obeys the variational equations (dynamics/tangent_series.hpp), at an event it is multiplied
/// by the saltation matrix (dynamics/saltation.hpp). The guards have gradients where they depend on the state: impact,
/// end of slip, friction limit, end of a cell of the friction, N = 0. Where full contact begins, the tilt and its rate
/// are lost. At instants that are fixed in time (breakpoints, a threshold of the base acceleration) vectors do not
/// change, except by a reset.
///
/// A guard with a rate below its rounding error has no usable derivative: it is counted, the event is taken as fixed in
/// time, and the vectors have no meaning from then on. The bound is the tolerance of Theta' for an impact that does not
/// end a chatter, and 2^-40 of the weight 4/3 (and of its rate of change) for forces and slip: rounding is 2^-52 of it.
template <class Motion, std::size_t count>
class TangentMotion : public Motion {
  using Tangent = dynamics::Tangent<double>;
  using Guard = dynamics::Guard;

 public:
  using Tangents = std::array<Tangent, count>;

  /// `start`: the vectors at the motion's present state; only their part within its contact state is used.
  TangentMotion(Motion motion, const Tangents& start) : Motion(std::move(motion)), at_event_(start) {
    for (Tangent& tangent : at_event_) tangent = within_contact(tangent, this->state());
    at_strobe_ = at_event_;
  }

  /// At the last strobe point; before it, the initial ones.
  [[nodiscard]] const Tangents& at_strobe() const { return at_strobe_; }
  [[nodiscard]] const NotDifferentiable& not_differentiable() const { return not_differentiable_; }

  /// From now on, notes in `log` how the guards are reached and passed.
  void log_guards(GuardLog& log) { log_ = &log; }

  /// Multiplies all vectors by a power of two, which rounds nothing.
  void scale(double power_of_two) {
    for (Tangents* vectors : {&tangents_, &at_event_, &at_strobe_}) {
      for (Tangent& vector : *vectors) vector = plus({}, power_of_two, vector);
    }
    for (double& delay : delays_) delay *= power_of_two;
    variation_.scale(power_of_two);
  }

  /// The vectors become these at the end of the present step; as in the constructor.
  void restart(const Tangents& vectors) { restart_ = vectors; }
  [[nodiscard]] bool restarts() const { return restart_.has_value(); }

  // For the lanes, which compute steps with vectors elsewhere.

  /// At the start of the coming step.
  [[nodiscard]] Tangents tangents() {
    if (!is_later_) return at_event_;
    const Tangent rates =
        rates_of(this->state(), this->base_motion(), this->kinetic_friction(), constants(this->state()));
    Tangents now;
    for (std::size_t i = 0; i < count; ++i) now[i] = plus(at_event_[i], -delays_[i], rates);
    return now;
  }
  /// Steps elsewhere have led to these.
  void set_tangents(const Tangents& now) {
    at_event_ = now;
    is_later_ = false;
  }
  void set_at_strobe(const Tangents& vectors) { at_strobe_ = vectors; }
  /// If they restart: now, in the state at the end of the step.
  void restart_in(const dynamics::State& end) {
    if (!restart_) return;
    for (std::size_t i = 0; i < count; ++i) tangents_[i] = within_contact((*restart_)[i], end);
    restart_.reset();
    set_tangents(tangents_);
  }
  /// The coming step ends so, `length` later.
  void end_elsewhere(double length, const Tangents& end, const dynamics::MovingBase& base) {
    time_went_on_ = length > 0.0;
    if (!time_went_on_) return;
    set_tangents(end);
    tangents_ = end;
    event_base_ = base;
    is_base_known_ = true;
  }

  [[nodiscard]] double expand(double reach) {
    const double length = Motion::expand(reach);
    is_expanded_ = false;
    return length;
  }

  void strobe(double x) {
    vary_step();
    at_strobe_ = tangents_until(x);
    Motion::strobe(x);
  }

  void move(double x) {
    time_went_on_ = x > 0.0;
    if (time_went_on_) {
      vary_step();
      if (log_ != nullptr) log_->note_minima(*this, x);
      tangents_ = tangents_until(x);
      length_ = x;
      is_base_known_ = false;
      set_tangents(tangents_);
      if (restart_) restart_in(this->state_at(x));
    }
    Motion::move(x);
  }

  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    if (fired.none() && !at_breakpoint) return Motion::reset(fired, at_breakpoint);
    const Event event{.guard = decisive(fired, at_breakpoint),
                      .before = this->state(),
                      .kinetic_friction = this->kinetic_friction(),
                      .impact = impact_of(fired, at_breakpoint)};
    if (time_went_on_) count_coincidence(fired, at_breakpoint);
    if (event.guard && time_went_on_ && !is_base_known_) event_base_ = moving_base(length_);
    Motion::reset(fired, at_breakpoint);
    pass(event);
  }

 private:
  struct Event {
    std::optional<Guard>
        guard;  ///< the one that decides what follows; absent at a breakpoint and where nothing changes
    dynamics::State before;
    double kinetic_friction;                             ///< in force before
    std::optional<dynamics::ImpactDerivative> impact{};  ///< where theta has become 0 with an impact
  };

  static constexpr double least_rate = 4.0 / 3.0 * 0x1p-40;

  /// The guard to which Automaton::respond responds, if that changes the state or the contact state.
  template <class Fired>
  [[nodiscard]] std::optional<Guard> decisive(const Fired& fired, bool at_breakpoint) const {
    const auto has_fired = [&fired](Guard guard) { return fired[static_cast<std::size_t>(guard)]; };
    if (has_fired(Guard::overturn) || has_fired(Guard::determinant)) return std::nullopt;
    const bool limit = has_fired(Guard::friction_inward) || has_fired(Guard::friction_outward);
    if (has_fired(Guard::tilt) && (time_went_on_ || !limit)) return Guard::tilt;
    for (const Guard guard : {Guard::slip, Guard::friction_inward, Guard::friction_outward, Guard::cell}) {
      if (has_fired(guard)) return guard;
    }
    if (has_fired(Guard::leave_right) || has_fired(Guard::leave_left) || at_breakpoint) return std::nullopt;
    for (const Guard guard : {Guard::normal, Guard::slip_presses}) {
      if (has_fired(guard)) return guard;
    }
    return std::nullopt;
  }

  template <class Fired>
  void count_coincidence(const Fired& fired, bool at_breakpoint) {
    int together = at_breakpoint ? 1 : 0;
    for (const Guard guard : {Guard::tilt, Guard::slip, Guard::friction_inward, Guard::friction_outward, Guard::cell}) {
      if (fired[static_cast<std::size_t>(guard)]) ++together;
    }
    if (together > 1) ++not_differentiable_.coincidences;
  }

  /// The derivative of the impact that reset() is about to apply.
  template <class Fired>
  [[nodiscard]] std::optional<dynamics::ImpactDerivative> impact_of(const Fired& fired, bool at_breakpoint) const {
    const dynamics::State& state = this->state();
    if (decisive(fired, at_breakpoint) != Guard::tilt || !(state.side * state.tilt_rate < 0.0)) return std::nullopt;
    const dynamics::Setting& setting = this->setting();
    const double restitution = coming_restitution();
    const dynamics::Edge& landing = setting.block.edge(state.tilt_rate);
    if (!this->coefficients().has_friction()) return sticking_derivative(restitution, landing);
    const bool slip_ends = fired[static_cast<std::size_t>(Guard::slip)];
    const dynamics::ImpactConditions before{.tilt_rate = state.tilt_rate,
                                            .slip_rate = slip_ends ? 0.0 : state.slip_rate,
                                            .restitution = restitution,
                                            .static_friction = this->coefficients().static_friction()};
    if (sticking_impact(before, setting.block, setting.impact_slip_rule)) {
      return sticking_derivative(restitution, landing);
    }
    dynamics::Clock clock = this->clock();
    if (at_breakpoint) clock.set(*this->course().progress.breakpoint());
    auto coefficients = this->coefficients();  // a copy makes the same draws
    return slipping_derivative(before, coefficients.kinetic_friction(clock), setting.block);
  }

  [[nodiscard]] double coming_restitution() const {
    if constexpr (dynamics::KnowsComingCoefficients<std::remove_cvref_t<decltype(this->coefficients())>>) {
      if (const auto constant = this->coefficients().constant_restitution()) return *constant;
    }
    auto coefficients = this->coefficients();  // a copy makes the same draw
    return coefficients.restitution(this->state().tilt_rate);
  }

  /// Through the event, after the motion has passed it.
  void pass(const Event& event) {
    if (event.guard && time_went_on_) delay(event);
    const dynamics::State& after = this->state();
    const bool lands = event.guard == Guard::tilt;
    for (Tangent& tangent : at_event_) {
      if (lands) {
        tangent = landed(tangent, event);
        if (after.tilt_rate == 0.0) tangent.tilt_rate = 0.0;  // a touch, or the end of a chatter
      }
      const bool ends_slip = (lands || event.guard == Guard::slip) && after.slip_rate == 0.0;
      if (ends_slip) tangent.slip_rate = 0.0;
    }
  }

  /// The change of state at the event: with that of its instant.
  void delay(const Event& event) {
    const Tangent rates = rates_of(event.before, event_base_.now, event.kinetic_friction, constants(event.before));
    const std::optional<dynamics::GuardSlope> guard = slope_of(event, rates);
    if (!guard) return;
    is_later_ = true;
    for (std::size_t i = 0; i < count; ++i) {
      delays_[i] = guard->delay(tangents_[i]);
      at_event_[i] = plus(tangents_[i], delays_[i], rates);
    }
  }

  /// Absent where the instant does not depend on the state; also where it has no derivative, which is counted.
  [[nodiscard]] std::optional<dynamics::GuardSlope> slope_of(const Event& event, const Tangent& rates) {
    switch (*event.guard) {
      case Guard::tilt: {
        const bool ends_chatter = event.before.tilt_rate != 0.0 && this->state().tilt_rate == 0.0;
        const double least = ends_chatter ? 0.0 : this->setting().tolerance * this->setting().block.shape_angle;
        if (log_ != nullptr) {
          log_->add({Guard::tilt, rates.tilt / this->setting().block.edge(event.before.side).shape_angle});
          if (!dynamics::is_rocking(this->state().contact)) log_->forget_chatter();
        }
        return unless_grazing({.gradient = {.tilt = 1.0}, .rate = rates.tilt}, least);
      }
      case Guard::slip:
        if (log_ != nullptr) log_->add({Guard::slip, rates.slip_rate});
        return unless_grazing({.gradient = {.slip_rate = 1.0}, .rate = rates.slip_rate}, least_rate);
      case Guard::friction_inward: return slope_of_forces(event, -1.0);
      case Guard::friction_outward: return slope_of_forces(event, 1.0);
      case Guard::cell: return unless_grazing({.gradient = {.slip = 1.0}, .rate = rates.slip}, least_rate);
      case Guard::normal: {
        // Without a change of the contact state the reset is the identity and the rates do not jump.
        const bool changes = event.before.contact == dynamics::ContactState::rock && this->slips();
        return changes ? unless_grazing(
                             dynamics::slope_of_forces(event.before, event_base_, constants(event.before), 1.0, 0.0),
                             least_rate)
                       : std::nullopt;
      }
      case Guard::slip_presses:
        return unless_grazing(dynamics::slope_of_pressing(event.before, event_base_, constants(event.before), rates),
                              least_rate);
      default: return std::nullopt;
    }
  }

  [[nodiscard]] std::optional<dynamics::GuardSlope> slope_of_forces(const Event& event, double by_friction) {
    const double mu_s = this->coefficients().static_friction();  // an onset of slip draws nothing
    const dynamics::GuardSlope guard =
        dynamics::slope_of_forces(event.before, event_base_, constants(event.before), mu_s, by_friction);
    if (log_ != nullptr) log_->add({*event.guard, guard.rate});
    return unless_grazing(guard, least_rate);
  }

  [[nodiscard]] std::optional<dynamics::GuardSlope> unless_grazing(const dynamics::GuardSlope& guard, double least) {
    if (std::abs(guard.rate) > least) return guard;
    ++not_differentiable_.grazings;
    return std::nullopt;
  }

  /// Behind the impact; in a touch without an impulse the rate is 0.
  [[nodiscard]] static Tangent landed(const Tangent& before, const Event& event) {
    Tangent after = before;
    after.tilt = 0.0;
    if (!event.impact) return after;
    const dynamics::ImpactDerivative& impact = *event.impact;
    after.tilt_rate =
        impact.tilt_rate_by_tilt_rate * before.tilt_rate + impact.tilt_rate_by_slip_rate * before.slip_rate;
    after.slip_rate =
        impact.slip_rate_by_tilt_rate * before.tilt_rate + impact.slip_rate_by_slip_rate * before.slip_rate;
    return after;
  }

  /// The first use of the step that `expand` has prepared: the vectors at its start, and the variational equations.
  void vary_step() {
    if (is_expanded_) return;
    is_expanded_ = true;
    const dynamics::State& state = this->state();
    tangents_ = tangents();
    set_tangents(tangents_);
    variation_.expand(this->series().rows(),
                      {.contact = state.contact,
                       .order = this->series().order(),
                       .has_vertical = this->excitation().has_vertical(),
                       .drag = frame_side(state) * state.slip_direction * this->kinetic_friction()},
                      constants(state), tangents_);
  }

  [[nodiscard]] Tangents tangents_until(double x) const { return variation_.at(x, this->series().rows()); }

  [[nodiscard]] dynamics::MovingBase moving_base(double x) const {
    const double side = frame_side(this->state());
    const auto& rows = this->series().rows();
    const int order = this->series().order();
    const auto slope = [x, order](const auto& row) {
      double sum = 0.0;
      for (int k = order; k > 0; --k) sum = base::fused(sum, x, k * row[static_cast<std::size_t>(k)]);
      return sum;
    };
    return {.now = this->base_at(x),
            .slope = {.horizontal = side * slope(rows.base),
                      .weight = this->excitation().has_vertical() ? slope(rows.weight) : 0.0}};
  }

  [[nodiscard]] dynamics::AnyConstants constants(const dynamics::State& of) const {
    return equation_constants(this->setting(), of.side);
  }

  dynamics::VariationOfStep<count> variation_;
  Tangents tangents_{};  ///< at the start of the step
  Tangents at_event_;    ///< changes of the state at the last event, before time went on
  Tangents at_strobe_{};
  std::array<double, count> delays_{};  ///< changes of the instant of that event, if is_later_
  bool is_later_ = false;               ///< its instant depends on the initial state
  double length_ = 0.0;                 ///< of the last step
  bool is_base_known_ = false;          ///< event_base_ is that at its end
  dynamics::MovingBase event_base_{};
  NotDifferentiable not_differentiable_;
  std::optional<Tangents> restart_;
  GuardLog* log_ = nullptr;
  bool is_expanded_ = false;  ///< `variation_` is that of the present step
  bool time_went_on_ = false;
};

}  // namespace rocking
