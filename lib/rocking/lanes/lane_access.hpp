#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/lane_state.hpp"
#include "rocking/lanes/row.hpp"

namespace rocking::lanes {
namespace {

template <class Real>
using TruthOf = decltype(std::declval<Real>() < std::declval<Real>());

/// The lanes from `first` on that one number type holds: what is constant for their kind, and the access to their
/// numbers in the lane state. `Shaking`: kind of the base motion.
template <Kind kind, class Shaking, class Real>
class LaneAccess {
 public:
  LaneAccess(LaneState& state, std::size_t first) : state_(state), first_(first) {}

  static constexpr bool slips = lanes::slips(kind);
  static constexpr bool tests_friction = lanes::tests_friction(kind);
  static constexpr bool is_brief = lanes::is_brief(kind);
  /// Each step ends with an interval of the friction grid; the intervals are known beforehand.
  static constexpr bool on_grid = slips && is_brief && !Shaking::has_knots;
  /// The lanes pass breakpoints.
  static constexpr bool passes_breakpoints = on_grid || Shaking::has_knots;
  /// dynamics::out_of_reach holds for this kind.
  static constexpr bool knows_reach = !slips && Shaking::bounds_acceleration && !Shaking::has_vertical;
  static constexpr std::size_t order = order_of(kind);

  [[nodiscard]] Real load(const LaneRow& row) const { return Row<Real>::load(row.data() + first_); }
  [[nodiscard]] dynamics::EquationConstants<Real> constants() const {
    dynamics::EquationConstants<Real> loaded;
    dynamics::for_each_constant(loaded, state_.constants, [this](Real& to, const LaneRow& row) { to = load(row); });
    return loaded;
  }
  void store(LaneRow& row, const Real& value) const { Row<Real>::store(value, row.data() + first_); }

  /// Puts the truth values of these lanes among those of all lanes.
  void mark(std::uint32_t& truths, std::uint32_t of_these) const {
    truths = (truths & ~(every_lane << first_)) | of_these << first_;
  }

 protected:
  [[nodiscard]] Real kinetic_friction() const {
    if constexpr (!on_grid) return load(state_.kinetic_friction);
    using base::select, base::smaller;
    const Real wanted =
        Row<Real>::load_each(&state_.intervals.kinetic_friction[first_], &state_.intervals.present[first_]);
    return smaller(select(wanted < Real(0.0), Real(0.0), wanted), load(state_.static_friction));
  }

  LaneState& state_;
  std::size_t first_;

 private:
  static constexpr std::uint32_t every_lane = (1U << Row<Real>::lanes) - 1U;
};

}  // namespace
}  // namespace rocking::lanes
