#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking {

/// A mode of a building, as it is seen from the floor.
struct BuildingMode {
  Quantity frequency_hz = 1.0;  ///< [Hz]
  Quantity damping_ratio = 0.05;
  Quantity factor = 1.0;  ///< participation factor times the shape at the floor [-]
  friend bool operator==(const BuildingMode&, const BuildingMode&) = default;
};

/// A linear building on a floor of which the block stands: its modes, or a uniform shear building, whose modes have f_i = (2i
/// - 1) f_1 and at the height h the factor 4/((2i - 1) pi) sin((2i - 1) pi h/2).
struct Building {
  Quantity frequency_hz = 1.0;  ///< f_1 [Hz]; not used with modes, nor are the next three
  Quantity damping_ratio = 0.05;
  Quantity height_ratio = 1.0;           ///< h, over the height of the building [-]
  int uniform_modes = 3;                 ///< number of modes
  std::vector<BuildingMode> modes = {};  ///< empty: a uniform shear building
  friend bool operator==(const Building&, const Building&) = default;
};

[[nodiscard]] bool is_drawn(const Building& building);

/// The most modes of a building.
inline constexpr std::size_t most_building_modes = 10;

/// Those of the mean building; all quantities are numbers.
[[nodiscard]] std::vector<BuildingMode> modes_of(const Building& building);

/// `on a floor at 0.8 of the height of a building of 1.5 Hz, 5 % damping`.
[[nodiscard]] std::string floor_in_words(const Building& building);

/// From the end of a ground motion on, the time in which the slowest mode of the mean building falls to a thousandth [s].
[[nodiscard]] double settling_time(const Building& building);

/// The motion of a floor: its horizontal acceleration is that of the ground plus the sum of factor times q'', where for each
/// mode q'' + 2 z w q' + w^2 q = -a, from rest, and a is linear between the samples of the ground: exact at each sample of the
/// floor. The steps of the ground are divided so that the shortest period of a mode has at least ten. Behind the last sample
/// of the ground the motion goes on, at its last step, until the acceleration stays below a thousandth of its peak. The
/// vertical acceleration is that of the ground. The bits are the same on every machine.
[[nodiscard]] std::vector<dynamics::GroundMotionSample> floor_motion(
    const std::vector<dynamics::GroundMotionSample>& ground, const Building& building);

}  // namespace rocking
