#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rocking::analysis {

/// How an attempt to draw ended.
struct Drawing {
  bool drawn = false;
  std::string reason;  ///< why not, and what would do; empty where it was drawn
};

/// Lets gnuplot carry out `folder/NAME.gp` for these formats (of `svg`, `png`, `pdf`); waits for it. gnuplot is sought as a
/// shell would. Throws std::system_error where no process can be started.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                                  const std::vector<std::string>& formats);

}  // namespace rocking::analysis
