#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// What is known of the coming step besides the state, from the event at its start. Replaced as a whole at each event.
struct KnownAtStart {
  bool lift_is_flat = false;            ///< w' = 0 exactly
  bool slip_is_flat = false;            ///< V' = 0 exactly
  bool normal_is_zero = false;          ///< N = 0 exactly
  double limit_sign = 0.0;              ///< sign of S F, if abs(F) = mu_s N exactly; else 0
  bool sticks_beyond_friction = false;  ///< until the next event; see start_slipping

  /// Once time has gone on.
  [[nodiscard]] KnownAtStart after_a_step() const {
    KnownAtStart rest;
    rest.sticks_beyond_friction = sticks_beyond_friction;
    return rest;
  }
  friend bool operator==(const KnownAtStart&, const KnownAtStart&) = default;
};

/// How the coming step follows on the last one. Replaced as a whole by each step and each reset.
struct Continuity {
  bool after_reset = true;       ///< the forces may have jumped: N and D are checked when the series are known
  std::int64_t standstills = 0;  ///< steps in a row in which no time went on

  [[nodiscard]] bool time_went_on() const { return standstills == 0; }  ///< in the last step

  [[nodiscard]] static constexpr Continuity after_a_step() { return {.after_reset = false, .standstills = 0}; }
  [[nodiscard]] constexpr Continuity after_a_standstill() const {
    return {.after_reset = false, .standstills = standstills + 1};
  }
  [[nodiscard]] constexpr Continuity after_events() const { return {.after_reset = true, .standstills = standstills}; }
};

}  // namespace rocking::dynamics
