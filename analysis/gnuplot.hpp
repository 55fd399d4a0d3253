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
  not_installed,  ///< the program that draws is missing
  broken_off,  ///< prevented by this machine: a signal, a full disk, a gnuplot without the format or without a message
  refused,     ///< gnuplot did not understand the script: an error of this program
};

struct Drawing {
  DrawingEnd end = DrawingEnd::refused;
  std::string reason;  ///< why there is no picture, and what to do; empty if it was drawn

  [[nodiscard]] bool is_drawn() const { return end == DrawingEnd::drawn; }
};

/// Which pictures to draw.
struct Pictures {
  std::vector<std::string> formats;  ///< of `svg`, `png`, `pdf`
  std::string ending;                ///< suffix after each name NAME.FORMAT
};

/// Runs gnuplot on `folder/NAME.gp` for these pictures and waits for it. gnuplot is looked up in PATH. If it is asked
/// to stop, gnuplot is killed and base::Stopped is thrown.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                                  const Pictures& pictures, base::StopRequest stop = {});

}  // namespace rocking::analysis
