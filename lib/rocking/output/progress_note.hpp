#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocking {

/// Progress of an active run, which it writes to a file for other processes.
struct ProgressNote {
  std::uint64_t process = 0;      ///< process id
  double elapsed_s = 0.0;         ///< since it started
  std::uint64_t done_before = 0;  ///< realisations that were done when it started
  std::uint64_t done = 0;
  std::uint64_t all = 0;
};

[[nodiscard]] std::string to_text(const ProgressNote& note);

/// Absent if the text is not a note, because it is being written or of another version.
[[nodiscard]] std::optional<ProgressNote> read_progress_note(std::string_view text);

}  // namespace rocking
