#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rocking {

/// Formats of files with recorded accelerations (lib/docs/ground-motions.md).
enum class RecordFormat : std::uint8_t { columns, peer_at2, esm_asc };

/// Their names in experiments, in the order of RecordFormat.
inline constexpr std::array<std::string_view, 3> record_format_names{"columns", "peer_at2", "esm_asc"};

/// Unit of the accelerations in a file. `g` is the gravity of the experiment, as in `amplitude_g`.
enum class RecordUnit : std::uint8_t { g, m_s2, cm_s2 };

/// Their names in experiments, in the order of RecordUnit.
inline constexpr std::array<std::string_view, 3> record_unit_names{"g", "m/s2", "cm/s2"};

[[nodiscard]] constexpr std::string_view name_of(RecordFormat format) {
  return record_format_names[static_cast<std::size_t>(format)];
}
[[nodiscard]] constexpr std::string_view name_of(RecordUnit unit) {
  return record_unit_names[static_cast<std::size_t>(unit)];
}

/// An acceleration of a file over `gravity` [m/s^2]. Of m/s^2 it is one division, of g the number itself.
[[nodiscard]] constexpr double over_gravity(double value, RecordUnit unit, double gravity) {
  switch (unit) {
    case RecordUnit::g: return value;
    case RecordUnit::m_s2: return value / gravity;
    case RecordUnit::cm_s2: break;
  }
  return value / 100.0 / gravity;
}

/// What an acceleration of 1 is in m/s^2.
[[nodiscard]] constexpr double in_m_s2(RecordUnit unit, double gravity) {
  switch (unit) {
    case RecordUnit::g: return gravity;
    case RecordUnit::m_s2: return 1.0;
    case RecordUnit::cm_s2: break;
  }
  return 0.01;
}

/// A unit as headers write it: `cm/s^2`, `CM/SEC/SEC`, `gal`, `G`. Absent if it is none of acceleration that is known.
[[nodiscard]] std::optional<RecordUnit> record_unit_written(std::string_view text);

/// The format of a file by its first lines: `peer_at2` if one has NPTS and DT, `esm_asc` if one begins with
/// SAMPLING_INTERVAL_S:, otherwise `columns`.
[[nodiscard]] RecordFormat recognised_format(std::string_view text);

}  // namespace rocking
