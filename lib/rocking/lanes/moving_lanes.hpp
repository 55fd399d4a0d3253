#pragma once

#include "rocking/lanes/lane_access.hpp"

namespace rocking::lanes {
namespace {

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
