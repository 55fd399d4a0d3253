#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rocking::analysis {

/// How an attempt to draw ended.
enum class DrawingEnd : std::uint8_t {
  drawn,
  no_gnuplot,  ///< it is not installed
  broken_off,  ///< this machine prevented it: a signal, a full disk, a gnuplot without the picture format
  refused,     ///< gnuplot did not understand the script, which is our fault
};

struct Drawing {
  DrawingEnd end = DrawingEnd::refused;
  std::string reason;  ///< why there is no picture, and what would do; empty where it was drawn

  [[nodiscard]] bool is_drawn() const { return end == DrawingEnd::drawn; }
};

/// Lets gnuplot carry out `folder/NAME.gp` for these formats (of `svg`, `png`, `pdf`); waits for it. The pictures are called
/// NAME.FORMAT with `ending` behind it. gnuplot is sought as a shell would. Throws std::system_error where no process can be
/// started.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                                  const std::vector<std::string>& formats, const std::string& ending);

}  // namespace rocking::analysis
