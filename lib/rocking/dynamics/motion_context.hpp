#pragma once

#include <cstdint>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/known_at_start.hpp"
#include "rocking/dynamics/observer.hpp"
#include "rocking/dynamics/peaks.hpp"
#include "rocking/dynamics/setting.hpp"

namespace rocking::dynamics {

/// A block on a moving base at an instant. Every rule of the mechanics is a function of it: a rule that changes the
/// state changes it here and reports the event.
template <CoefficientSource Coefficients>
class MotionContext {
 public:
  MotionContext(const Setting& of_block, const Clock& start, const Coefficients& source, const Excitation& shaking,
                Observer& observer)
      : setting(of_block), clock(start), coefficients(source), excitation(shaking), observer_(&observer) {}

  [[nodiscard]] bool slips() const { return is_sliding(state.contact); }

  /// Amplitude of the horizontal base acceleration in force, in g.
  [[nodiscard]] double base_amplitude() { return coefficients.amplitude(clock) * excitation.unit(setting.block); }

  /// Horizontal base acceleration alpha now, in g.
  [[nodiscard]] double base_acceleration() {
    if (accelerated_at_ != clock.now()) {  // several rules need it at the same instant
      accelerated_at_ = clock.now();
      base_acceleration_ = excitation.horizontal(clock, base_amplitude());
    }
    return base_acceleration_;
  }

  [[nodiscard]] double weight() const { return excitation.weight(clock); }  ///< 1 + alpha_v now
  [[nodiscard]] BaseMotion base_motion() { return {.horizontal = base_acceleration(), .weight = weight()}; }
  [[nodiscard]] double kinetic_friction() { return coefficients.kinetic_friction(clock); }  ///< mu_k now

  /// X at which friction changes if the block goes on slipping; absent: nowhere.
  [[nodiscard]] std::optional<double> cell_end() const {
    if constexpr (HasFrictionOfPlace<Coefficients>) {
      if (slips()) return coefficients.cell_end(state.slip_direction);
    }
    return std::nullopt;
  }

  /// The block is at X: its friction is that of the cell.
  void find_cell() {
    if constexpr (HasFrictionOfPlace<Coefficients>) coefficients.place(state.slip);
  }

  /// It has come to the end of its cell.
  void enter_next_cell() {
    if constexpr (HasFrictionOfPlace<Coefficients>) coefficients.enter_cell(state.slip_direction);
  }

  /// From now on, reports events and strobe points to `observer`.
  void observe_with(Observer& observer) { observer_ = &observer; }
  [[nodiscard]] Observer& observer() const { return *observer_; }
  void record(EventKind kind) { observer_->event(kind, clock.tau(), state); }

  [[nodiscard]] const std::optional<Termination>& termination() const { return termination_; }
  [[nodiscard]] bool ended() const { return termination_.has_value(); }
  void end(Termination reason) { termination_ = reason; }
  /// Past the horizon.
  void go_on() {
    if (termination_ == Termination::reached_horizon) termination_.reset();
  }

  void set_peaks(const TiltPeaks<double>& values) {
    peaks.tilt = values.tilt;
    peaks.tilt_rate = values.tilt_rate;
  }

  /// Goes on under other circumstances.
  void replace(const Setting& of_block, const Clock& now, const Coefficients& source, const Excitation& shaking) {
    setting = of_block;
    clock = now;
    coefficients = source;
    excitation = shaking;
    known = {};
    accelerated_at_.reset();
  }

  Setting setting;
  Clock clock;
  Coefficients coefficients;
  Excitation excitation;
  State state;
  KnownAtStart known;                ///< of the coming step
  Peaks peaks;                       ///< the largest values so far, without those of a slip in progress
  std::uint64_t contradictions = 0;  ///< how often the block stuck although friction does not suffice

 private:
  Observer* observer_;
  std::optional<Termination> termination_;
  std::optional<Instant> accelerated_at_;  ///< instant of the base acceleration below
  double base_acceleration_ = 0.0;
};

}  // namespace rocking::dynamics
