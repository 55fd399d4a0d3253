#pragma once

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

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
