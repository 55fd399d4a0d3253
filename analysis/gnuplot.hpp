#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rocking/base/stop_request.hpp"

namespace rocking::analysis {

/// How an attempt to draw ended.
struct Drawing {
  bool drawn = false;
  std::string reason;  ///< why not, and what would do; empty where it was drawn
};

/// Lets gnuplot carry out `folder/NAME.gp` for these formats (of `svg`, `png`, `pdf`); waits for it. gnuplot is sought as a
/// shell would. Once it is asked to stop, gnuplot is killed and base::Stopped is thrown.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                                  const std::vector<std::string>& formats, base::StopRequest stop = {});

}  // namespace rocking::analysis
