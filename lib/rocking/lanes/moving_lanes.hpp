#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/lanes/lane_state.hpp"
#include "rocking/lanes/row.hpp"

namespace rocking::lanes {
namespace {

/// The lanes from `first` on that one number type holds: access to their numbers in the lane state.
template <class Real>
struct LaneAccess {
  LaneState& state;
  std::size_t first;

  [[nodiscard]] Real load(const LaneRow& row) const { return Row<Real>::load(row.data() + first); }
  void store(LaneRow& row, const Real& value) const { Row<Real>::store(value, row.data() + first); }

  template <class Form>
  [[nodiscard]] typename Form::Constants constants() const {
    typename Form::Constants loaded;
    dynamics::for_each_constant(loaded, state.constants, [this](Real& to, const LaneRow& row) { to = load(row); });
    return loaded;
  }

  /// Puts the truth values of these lanes among those of all lanes.
  void mark(std::uint32_t& truths, std::uint32_t of_these) const {
    constexpr std::uint32_t every_lane = (1U << Row<Real>::lanes) - 1U;
    truths = (truths & ~(every_lane << first)) | of_these << first;
  }
};

/// Lanes that move on, and access to them.
template <class Real>
struct MovingLanes {
  const LaneAccess<Real>& lanes;
  TruthOf<Real> moved;

  void store(LaneRow& row, const Real& after, const Real& before) const {
    using base::select;
    lanes.store(row, select(moved, after, before));
  }
};

/// The same where all lanes that have a run move on: the others may get any numbers.
template <class Real>
struct AllMoving {
  const LaneAccess<Real>& lanes;

  void store(LaneRow& row, const Real& after, const Real&) const { lanes.store(row, after); }
};

}  // namespace
}  // namespace rocking::lanes
