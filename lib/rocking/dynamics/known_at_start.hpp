#pragma once

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

}  // namespace rocking::dynamics
