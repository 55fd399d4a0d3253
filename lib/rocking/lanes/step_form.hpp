#pragma once

#include <cstddef>

#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/row.hpp"

namespace rocking::lanes {
namespace {

/// What is the same in all lanes of a kernel, known to the compiler. `ShakingKind`: kind of the base motion; `Number`:
/// type of the numbers, which holds a number of lanes; `with_tangents`: the lanes carry tangent vectors.
template <Kind kind, dynamics::BlockForm form, class ShakingKind, class Number, bool with_tangents>
struct StepForm {
  using Shaking = ShakingKind;
  using Constants = dynamics::EquationConstants<Number, form>;
  using Real = Number;
  using Truth = TruthOf<Real>;

  static constexpr bool has_tangents = with_tangents;
  static constexpr bool slips = lanes::slips(kind);
  static constexpr bool tests_friction = lanes::tests_friction(kind);
  static constexpr bool is_brief = lanes::is_brief(kind);
  /// Each step ends with an interval of the friction grid; the intervals are known beforehand.
  static constexpr bool on_grid = slips && is_brief && !Shaking::has_knots;
  /// The lanes pass breakpoints.
  static constexpr bool passes_breakpoints = on_grid || Shaking::has_knots;
  /// dynamics::out_of_reach holds for this kind.
  static constexpr bool knows_reach = !slips && Shaking::bounds_acceleration && !Shaking::has_vertical;
  /// Some impacts are computed here: not where the constants change with the side.
  static constexpr bool may_land = knows_reach && !has_tangents && form == dynamics::BlockForm::rectangle;
  static constexpr int order = order_of(kind);
  /// Number of guards that are armed in an ordinary step (dynamics::ArmedGuards::is_ordinary).
  static constexpr std::size_t guards = slips ? 4 : tests_friction ? 5 : 3;
};

}  // namespace
}  // namespace rocking::lanes
