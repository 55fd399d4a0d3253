#pragma once

#include <cstdint>

#include "differential/peer/scene.hpp"

namespace rocking::peer {

/// Quantities that depend on time only: the sine of the base, the grid of friction, the excitation periods, the strobe.
/// Instants are in tau; an instant within a rounding of a boundary counts as after it.
class Timetable {
 public:
  explicit Timetable(const Scene& scene);

  [[nodiscard]] double period() const { return period_; }
  [[nodiscard]] double sine(double tau) const;  ///< 0 after a pulse

  /// Number of strobes, intervals of friction and excitation periods (between zeros of the sine) up to tau.
  [[nodiscard]] std::int64_t strobes(double tau) const;
  [[nodiscard]] std::int64_t interval(double tau) const;
  [[nodiscard]] std::int64_t excitation_period(double tau) const;

  /// The next instant at which something is sampled or redrawn.
  [[nodiscard]] double next_break(double tau, bool slips) const;

  /// The next instant at which the sine reaches `up` > 0 or -`down` < 0; infinite if there is none.
  [[nodiscard]] double next_reach(double tau, double up, double down) const;

 private:
  double frequency_;
  double phase_;
  double period_;
  double pitch_;  ///< of the grid
  bool pulse_;
  bool friction_changes_;
  bool amplitude_changes_;
};

}  // namespace rocking::peer
