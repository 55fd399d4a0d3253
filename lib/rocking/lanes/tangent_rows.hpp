#pragma once

#include <array>
#include <cstddef>

#include "rocking/dynamics/tangent.hpp"
#include "rocking/lanes/lane_row.hpp"

namespace rocking::lanes {

/// Tangent vectors of a motion in a lane: the derivatives with respect to theta, w and V.
inline constexpr std::size_t tangent_count = 3;
using Tangents = std::array<dynamics::Tangent<double>, tangent_count>;

/// Tangent vectors in fixed axes. No kernel changes their part along X. Only the end of a cell of the friction depends on
/// it; where friction has cells, no lane computes a step with slip, and without slip this part is constant.
struct TangentRows {
  struct Vector {
    LaneRow tilt;
    LaneRow tilt_rate;
    LaneRow slip_rate;
  };
  using Vectors = std::array<Vector, tangent_count>;

  std::array<LaneRow, tangent_count> slip;  ///< their part along X

  Vectors now;        ///< at the start of the coming step
  Vectors at_strobe;  ///< in the lanes that passed a strobe point
  // In the lanes that were not moved on, at the first event or the end of the step:
  Vectors at_end;
  LaneRow end_base;        ///< S alpha
  LaneRow end_base_slope;  ///< its rate of change
};

/// At the start of the coming step.
inline void load_vectors(TangentRows& rows, std::size_t lane, const Tangents& vectors) {
  for (std::size_t i = 0; i < tangent_count; ++i) {
    rows.now[i].tilt[lane] = vectors[i].tilt;
    rows.now[i].tilt_rate[lane] = vectors[i].tilt_rate;
    rows.slip[i][lane] = vectors[i].slip;
    rows.now[i].slip_rate[lane] = vectors[i].slip_rate;
  }
}

/// `at`: one of those in `rows`.
[[nodiscard]] inline Tangents vectors_of(const TangentRows& rows, const TangentRows::Vectors& at, std::size_t lane) {
  Tangents vectors;
  for (std::size_t i = 0; i < tangent_count; ++i) {
    vectors[i] = {.tilt = at[i].tilt[lane],
                  .tilt_rate = at[i].tilt_rate[lane],
                  .slip = rows.slip[i][lane],
                  .slip_rate = at[i].slip_rate[lane]};
  }
  return vectors;
}

}  // namespace rocking::lanes
