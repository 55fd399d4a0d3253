#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/scene/ground_motion_reading.hpp"

namespace rocking {

/// The warning of a file that does not state the unit of its accelerations.
[[nodiscard]] std::string unit_assumed(RecordUnit unit);

/// An acceleration of a file over `gravity` [m/s^2]. Of m/s^2 it is one division, of g the number itself.
[[nodiscard]] constexpr double over_gravity(double value, RecordUnit unit, double gravity) {
  switch (unit) {
    case RecordUnit::g: return value;
    case RecordUnit::m_s2: return value / gravity;
    case RecordUnit::cm_s2: return value / 100.0 / gravity;
    case RecordUnit::mm_s2: return value / 1000.0 / gravity;
    case RecordUnit::mg: return value / 1000.0;
    case RecordUnit::percent_g: return value / 100.0;
    case RecordUnit::ft_s2: return value * 0.3048 / gravity;
    case RecordUnit::in_s2: break;
  }
  return value * 0.0254 / gravity;
}

/// What an acceleration of 1 is in m/s^2.
[[nodiscard]] constexpr double in_m_s2(RecordUnit unit, double gravity) {
  switch (unit) {
    case RecordUnit::g: return gravity;
    case RecordUnit::m_s2: return 1.0;
    case RecordUnit::cm_s2: return 0.01;
    case RecordUnit::mm_s2: return 0.001;
    case RecordUnit::mg: return 0.001 * gravity;
    case RecordUnit::percent_g: return 0.01 * gravity;
    case RecordUnit::ft_s2: return 0.3048;
    case RecordUnit::in_s2: break;
  }
  return 0.0254;
}

/// What a unit in a header measures. `multiple`: a unit of acceleration with a factor before it that makes none of the known
/// ones, `0.1 g`; `scaled`: with a factor behind it, of the unit or of the numbers.
enum class UnitKind : std::uint8_t { acceleration, multiple, scaled, velocity, displacement, time, unknown };

/// Whether it is a unit of acceleration with a factor that makes none of the known ones.
[[nodiscard]] constexpr bool has_factor(UnitKind kind) {
  return kind == UnitKind::multiple || kind == UnitKind::scaled;
}

struct WrittenUnit {
  UnitKind kind = UnitKind::unknown;
  RecordUnit acceleration = RecordUnit::g;  ///< of kind `acceleration`
};

/// Most characters of a unit in a header.
inline constexpr std::size_t longest_unit = 60;

/// A unit as headers write it: `cm/s^2`, `CM/SEC/SEC`, `GALS`, `(g)`, `in/sec**2`, `% g`, `cm/s`; with a factor before it,
/// `10^-2 m/s2`, `0.001 g`, `milli-g`. Behind it, `g*1000`, a factor is of the unit or of the numbers: that is `scaled`.
/// Unknown if longer than longest_unit.
[[nodiscard]] WrittenUnit unit_written(std::string_view text);

}  // namespace rocking
