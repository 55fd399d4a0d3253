#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rocking/base/stop_request.hpp"

namespace rocking::analysis {

/// How an attempt to draw ended.
enum class DrawingEnd : std::uint8_t {
  drawn,
  no_gnuplot,  ///< it is not installed
  broken_off,  ///< this machine prevented it: a signal, a full disk, a gnuplot without the picture format or without a message
  refused,     ///< gnuplot did not understand the script, which is our fault
};

struct Drawing {
  DrawingEnd end = DrawingEnd::refused;
  std::string reason;  ///< why there is no picture, and what would do; empty where it was drawn

  [[nodiscard]] bool is_drawn() const { return end == DrawingEnd::drawn; }
};

/// Which pictures to draw.
struct Pictures {
  std::vector<std::string> formats;  ///< of `svg`, `png`, `pdf`
  std::string ending;                ///< behind each name NAME.FORMAT
};

/// Lets gnuplot carry out `folder/NAME.gp` for these pictures; waits for it. gnuplot is sought as a shell would. Once it is
/// asked to stop, gnuplot is killed and base::Stopped is thrown.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name, const Pictures& pictures,
                                  base::StopRequest stop = {});

}  // namespace rocking::analysis
