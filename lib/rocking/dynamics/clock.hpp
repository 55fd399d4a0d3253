#pragma once

#include <cstdint>

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

}  // namespace rocking::dynamics
