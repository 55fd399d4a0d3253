#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocking::report {

/// What a run at work tells others of itself, in a file of its own.
struct ProgressNote {
  std::uint64_t process = 0;      ///< its number on its machine
  double elapsed_s = 0.0;         ///< since it began
  std::uint64_t done_before = 0;  ///< realisations that were done when it began
  std::uint64_t done = 0;
  std::uint64_t all = 0;
};

[[nodiscard]] std::string to_text(const ProgressNote& note);

/// Absent where the text is no such note: one that is being written, or of another version.
[[nodiscard]] std::optional<ProgressNote> read_progress_note(std::string_view text);

}  // namespace rocking::report
