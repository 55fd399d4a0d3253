#pragma once

#include <cstdint>

#include "differential/peer/scene.hpp"

namespace rocking::peer {

/// What depends on time alone: the base's sine, the grid of friction, the excitation's periods, the strobe. Instants
/// are tau; one that is nearer to a boundary than a rounding counts as after it.
class Timetable {
 public:
  explicit Timetable(const Scene& scene);

  [[nodiscard]] double period() const { return period_; }
  [[nodiscard]] double sine(double tau) const;

  /// How many strobes, intervals of friction and excitation periods (between zeros of the sine) have gone by.
  [[nodiscard]] std::int64_t strobes(double tau) const;
  [[nodiscard]] std::int64_t interval(double tau) const;
  [[nodiscard]] std::int64_t excitation_period(double tau) const;

  /// The next instant at which something is sampled or drawn anew.
  [[nodiscard]] double next_break(double tau, bool slips) const;

  /// The next instant at which the sine reaches `level` > 0 or -`level`; infinite if it never does.
  [[nodiscard]] double next_reach(double tau, double level) const;

 private:
  double frequency_;
  double phase_;
  double period_;
  double pitch_;  ///< of the grid
  bool friction_changes_;
  bool amplitude_changes_;
};

}  // namespace rocking::peer
