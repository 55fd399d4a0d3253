#pragma once

#include <array>
#include <cstddef>

#include "rocking/dynamics/tangent.hpp"
#include "rocking/lanes/lane_row.hpp"

namespace rocking::lanes {

/// Tangent vectors of a motion in a lane: the derivatives with respect to theta, w and V.
inline constexpr std::size_t tangent_count = 3;
using Tangents = std::array<dynamics::Tangent<double>, tangent_count>;

/// Tangent vectors in fixed axes, without their part along X, on which nothing in a lane depends.
struct TangentRows {
  struct Vector {
    LaneRow tilt;
    LaneRow tilt_rate;
    LaneRow slip_rate;
  };
  using Vectors = std::array<Vector, tangent_count>;

  Vectors now;        ///< at the start of the coming step
  Vectors at_strobe;  ///< in the lanes that passed a strobe point
  // In the lanes that were not moved on, at the first event or the end of the step:
  Vectors at_end;
  LaneRow end_base;        ///< S alpha
  LaneRow end_base_slope;  ///< its rate of change
};

inline void load_vectors(TangentRows::Vectors& rows, std::size_t lane, const Tangents& vectors) {
  for (std::size_t i = 0; i < tangent_count; ++i) {
    rows[i].tilt[lane] = vectors[i].tilt;
    rows[i].tilt_rate[lane] = vectors[i].tilt_rate;
    rows[i].slip_rate[lane] = vectors[i].slip_rate;
  }
}

[[nodiscard]] inline Tangents vectors_of(const TangentRows::Vectors& rows, std::size_t lane) {
  Tangents vectors;
  for (std::size_t i = 0; i < tangent_count; ++i) {
    vectors[i] = {
        .tilt = rows[i].tilt[lane], .tilt_rate = rows[i].tilt_rate[lane], .slip_rate = rows[i].slip_rate[lane]};
  }
  return vectors;
}

}  // namespace rocking::lanes
