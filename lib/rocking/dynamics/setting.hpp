#pragma once

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// What a scene fixes for a realisation.
struct Setting {
  Geometry block;
  double inertia;  ///< J in the equations of slip
  ImpactSlipRule impact_slip_rule;
  double tolerance;              ///< of a step, in Theta and Theta'; of a hop, see hop_is_too_small
  bool ends_at_balance = false;  ///< where abs(Theta) is 1 for the first time, as overturned
};

/// Constants of the equations between events, of a block that stands or rocks on one side. `Real` is a number of one
/// motion, a pack of lanes, or a row of a table with a number for each lane.
///
/// The sine and cosine of the equations are the lever arms of the edge over R: s = r_S sin(phi), c = r_S cos(phi). With
/// them the equations of both forms are the same, but for the numbers that are constants for a rectangle.
template <class Real, BlockForm block_form = BlockForm::rectangle>
struct EquationConstants {
  static constexpr BlockForm form = block_form;
  static constexpr double load = 4.0 / 3.0;

  Real shape_angle;  ///< psi
  Real sine;         ///< sin(psi)
  Real cosine;       ///< cos(psi)
  Real inertia;      ///< J

  /// w' without slip of a block that turns about its edge, from beta c - g s.
  template <class Number>
  [[nodiscard]] static const Number& geared(const Number& moment) {
    return moment;
  }
  template <class Number>
  [[nodiscard]] static const base::SinCos<Number>& levers(const base::SinCos<Number>& angle) {
    return angle;
  }
};

template <class Real>
struct EquationConstants<Real, BlockForm::general> {
  static constexpr BlockForm form = BlockForm::general;

  Real shape_angle;  ///< psi_S
  Real sine;         ///< r_S sin(psi_S)
  Real cosine;       ///< r_S cos(psi_S)
  Real inertia;      ///< J
  Real load;         ///< 1 + J
  Real radius;       ///< r_S
  Real gain;         ///< (1 + J)/(J + r_S^2)
  Real tilt_scale;   ///< psi of the nearer edge over psi_S

  template <class Number>
  [[nodiscard]] Number geared(const Number& moment) const {
    return Number(gain) * moment;
  }
  template <class Number>
  [[nodiscard]] base::SinCos<Number> levers(const base::SinCos<Number>& angle) const {
    return {radius * angle.sine, radius * angle.cosine};
  }
};

/// Of one motion, whatever its block: for what is computed at events only. The numbers of a rectangle give the same bits
/// in it as EquationConstants<double>.
using AnyConstants = EquationConstants<double, BlockForm::general>;

/// Calls use(a's constant, b's constant) for each that both have.
template <class A, BlockForm form_of_a, class B, BlockForm form_of_b, class Use>
void for_each_constant(EquationConstants<A, form_of_a>& a, const EquationConstants<B, form_of_b>& b, Use&& use) {
  // A member that is not named here does not compile.
  if constexpr (form_of_a == BlockForm::general) {
    [[maybe_unused]] auto& [angle, sine, cosine, inertia, load, radius, gain, tilt_scale] = a;
  } else {
    [[maybe_unused]] auto& [angle, sine, cosine, inertia] = a;
  }
  use(a.shape_angle, b.shape_angle);
  use(a.sine, b.sine);
  use(a.cosine, b.cosine);
  use(a.inertia, b.inertia);
  if constexpr (form_of_a == BlockForm::general && form_of_b == BlockForm::general) {
    use(a.load, b.load);
    use(a.radius, b.radius);
    use(a.gain, b.gain);
    use(a.tilt_scale, b.tilt_scale);
  }
}

/// Of a block on this side.
[[nodiscard]] inline AnyConstants equation_constants(const Setting& setting, double side) {
  const Edge& edge = setting.block.edge(side);
  return {.shape_angle = edge.shape_angle,
          .sine = edge.sine,
          .cosine = edge.cosine,
          .inertia = setting.inertia,
          .load = setting.block.load,
          .radius = edge.radius,
          .gain = edge.rocking_gain,
          .tilt_scale = edge.tilt_scale};
}

/// Calls use(constants) with those of the block's form.
template <class Use>
[[gnu::always_inline]] inline decltype(auto) with_constants(const Setting& setting, double side, Use&& use) {
  if (!setting.block.is_rectangle()) [[unlikely]]
    return use(equation_constants(setting, side));
  const Geometry& block = setting.block;
  return use(EquationConstants<double>{
      .shape_angle = block.shape_angle, .sine = block.sine, .cosine = block.cosine, .inertia = setting.inertia});
}

/// The levers s = r_S sin(phi) and c = r_S cos(phi) of the edge, phi = psi_S - abs(theta) being the angle of the
/// edge-to-centre line from the vertical. `tilt` is abs(theta), or S theta; at 0 they are exactly those of psi_S.
template <base::Lane Real, BlockForm form>
[[nodiscard]] inline base::SinCos<Real> edge_angle(const Real& tilt, const EquationConstants<Real, form>& constants) {
  using base::in_any, base::select;
  const Real phi = constants.shape_angle - tilt;
  const auto is_small = Real(-base::almost_quarter_pi) < phi && phi < Real(base::almost_quarter_pi);
  const auto tilted = constants.levers(in_any(!is_small) ? base::sin_cos(phi) : base::reduced_sin_cos(phi));
  const auto is_flat = tilt == Real(0.0);
  return {select(is_flat, constants.sine, tilted.sine), select(is_flat, constants.cosine, tilted.cosine)};
}

template <BlockForm form>
[[nodiscard]] inline base::SinCos<double> edge_angle(const State& state,
                                                     const EquationConstants<double, form>& constants) {
  return edge_angle(state.side * state.tilt, constants);
}

}  // namespace rocking::dynamics
