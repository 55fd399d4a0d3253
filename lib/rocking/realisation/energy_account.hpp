#pragma once

namespace rocking {

/// Energy balance of a realisation, over m R^2 p^2, in the frame of the base. The work of the base is that of the
/// inertia force - (4/3) alpha on the centre of mass (and of - (4/3) alpha_v).
struct EnergyAccount {
  double at_start = 0.0;  ///< kinetic energy plus (4/3) cos(phi) of the weight
  double at_end = 0.0;
  double base_work = 0.0;
  double friction_work = 0.0;      ///< of kinetic friction; never > 0 while N > 0
  double lost_in_impacts = 0.0;    ///< including what the end of a chatter neglects
  double gained_in_impacts = 0.0;  ///< energy added by some impacts; 0 except for squat blocks with e > 1/3

  /// Difference that the equations of motion leave unexplained: 0 to within rounding and tolerance if the mechanics is
  /// right.
  [[nodiscard]] double unaccounted() const {
    return at_end - at_start - base_work - friction_work - gained_in_impacts + lost_in_impacts;
  }
};

}  // namespace rocking
