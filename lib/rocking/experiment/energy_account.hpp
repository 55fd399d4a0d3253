#pragma once

namespace rocking::experiment {

/// Where the energy of a realisation came from and went, over m R^2 p^2, as seen from the base: the base's work is that of
/// the inertia force - (4/3) alpha on the centre of mass (and of - (4/3) alpha_v).
struct EnergyAccount {
  double at_start = 0.0;  ///< kinetic, and (4/3) cos(phi) of the weight
  double at_end = 0.0;
  double base_work = 0.0;
  double friction_work = 0.0;      ///< of kinetic friction; never > 0 while N > 0
  double lost_in_impacts = 0.0;    ///< and in what the end of a chatter leaves out
  double gained_in_impacts = 0.0;  ///< what some impacts made; 0 but for squat blocks with e > 1/3

  /// What the equations of motion add and nothing accounts for: 0 to rounding and tolerance in right mechanics.
  [[nodiscard]] double unaccounted() const {
    return at_end - at_start - base_work - friction_work - gained_in_impacts + lost_in_impacts;
  }
};

}  // namespace rocking::experiment
