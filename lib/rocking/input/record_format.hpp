#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rocking {

/// Formats of files with recorded accelerations (lib/docs/ground-motions.md).
enum class RecordFormat : std::uint8_t { columns, peer_at2, esm_asc };

/// Their names in experiments, in the order of RecordFormat.
inline constexpr std::array<std::string_view, 3> record_format_names{"columns", "peer_at2", "esm_asc"};

[[nodiscard]] constexpr std::string_view name_of(RecordFormat format) {
  return record_format_names[static_cast<std::size_t>(format)];
}

/// The format of a file by its first lines: `peer_at2` if one has NPTS and DT, `esm_asc` if one begins with
/// SAMPLING_INTERVAL_S:, otherwise `columns`.
[[nodiscard]] RecordFormat recognised_format(std::string_view text);

}  // namespace rocking
