#pragma once

#include <cstdint>

#include "rocking/base/lane.hpp"

namespace rocking::dynamics {

/// A count of excitation periods and the time since the last one began.
struct Instant {
  std::int64_t period = 0;
  double time = 0.0;

  friend bool operator==(const Instant&, const Instant&) = default;
};

/// Time as a count of excitation periods and the time within the current one.
///
/// A period starts where the argument of the base motion's sine is a multiple of 2 pi, so that the excitation is
/// sin(Omega_h u) with u < T in runs of any length: no digit is lost to accumulated time, and the strobe does not
/// drift.
class Clock {
 public:
  /// At tau = 0. `frequency` = Omega_h; `phase` = Phi in [0, 2 pi).
  Clock(double frequency, double phase);

  [[nodiscard]] const Instant& now() const { return now_; }              ///< period >= 0, time u in [0, T)
  [[nodiscard]] double period_length() const { return length_; }         ///< T = 2 pi/Omega_h
  [[nodiscard]] double frequency() const { return frequency_; }          ///< Omega_h
  [[nodiscard]] double angle() const { return frequency_ * now_.time; }  ///< argument of the base motion's sine [rad]
  [[nodiscard]] double start() const { return start_; }                  ///< u at tau = 0
  [[nodiscard]] double tau() const { return static_cast<double>(now_.period) * length_ + (now_.time - start_); }

  /// Instants closer than this are simultaneous: a few roundings of a time within a period.
  [[nodiscard]] double resolution() const { return 0x1p-49 * length_; }

  [[nodiscard]] double until(const Instant& instant) const { return between(now_, instant); }
  [[nodiscard]] double between(const Instant& from, const Instant& to) const {
    return static_cast<double>(to.period - from.period) * length_ + (to.time - from.time);
  }

  /// A duration > 0 that is lost to rounding moves the clock to the next double: otherwise an event that recurs at once
  /// would find the same instant endlessly.
  void advance(double duration);

  /// Sets the clock to an instant that it has reached up to rounding.
  void set(const Instant& instant) { now_ = wrapped(instant); }

  /// The same instant, with a time within its period.
  [[nodiscard]] Instant wrapped(Instant instant) const {
    while (instant.time >= length_) {  // exact while the time is below two periods
      instant.time -= length_;
      ++instant.period;
    }
    return instant;
  }

 private:
  double frequency_;
  double length_;
  double start_;
  Instant now_;
};

/// When a run is sampled and how long it is.
struct Schedule {
  Instant first_strobe;      ///< the following ones come a period apart
  std::int64_t strobes = 0;  ///< after the last the run ends
};

/// How far a run has come in its schedule.
class StrobeSchedule {
 public:
  explicit StrobeSchedule(const Schedule& schedule) : next_(schedule.first_strobe), left_(schedule.strobes) {}

  [[nodiscard]] const Instant& next() const { return next_; }
  [[nodiscard]] Instant last() const {
    return {.period = next_.period - 1, .time = next_.time};
  }                                                          ///< the one passed last
  [[nodiscard]] std::int64_t left() const { return left_; }  ///< strobe points until the end of the run
  [[nodiscard]] std::int64_t steps_since_last() const { return steps_since_last_; }

  void pass() {
    ++next_.period;
    --left_;
    steps_since_last_ = 0;
  }
  void count_step() { ++steps_since_last_; }
  /// Of steps that were not counted one by one.
  void set_steps_since_last(std::int64_t steps) { steps_since_last_ = steps; }
  void extend(std::int64_t more) { left_ += more; }

 private:
  Instant next_;
  std::int64_t left_;
  std::int64_t steps_since_last_ = 0;
};

/// What base motions need of a clock, for one motion or a pack; with the expressions of Clock.
template <base::Lane Real>
struct Moment {
  Real period;         ///< count of excitation periods
  Real time;           ///< since the last one began
  Real period_length;  ///< T
  Real frequency;      ///< Omega_h

  [[nodiscard]] Real until(const Real& other_period, const Real& other_time) const {
    return (other_period - period) * period_length + (other_time - time);
  }
};

[[nodiscard]] inline Moment<double> moment_of(const Clock& clock) {
  return {.period = static_cast<double>(clock.now().period),
          .time = clock.now().time,
          .period_length = clock.period_length(),
          .frequency = clock.frequency()};
}

}  // namespace rocking::dynamics
