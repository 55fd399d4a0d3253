#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace rocking::program {

/// Writes figures into a folder, which is made if need be; returns the files. Without gnuplot says so on standard error, and
/// leaves data and scripts. Throws std::system_error with the path.
[[nodiscard]] std::vector<std::string> write_figures(const std::vector<analysis::Figure>& figures,
                                                     const std::filesystem::path& folder);

}  // namespace rocking::program
