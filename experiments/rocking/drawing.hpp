#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"
#include "run_folder.hpp"

namespace rocking::program {

/// The figures of a run, with its realisations where its folder has them. Throws as RunFolder::open_sound_store
/// does.
[[nodiscard]] std::vector<analysis::Figure> figures_of(const RunFolder& folder, const analysis::RunReport& report);

/// Writes figures into a folder, which is made if need be; returns the files. Without gnuplot says so on standard error, and
/// leaves data and scripts. Throws std::system_error with the path.
[[nodiscard]] std::vector<std::string> write_figures(const std::vector<analysis::Figure>& figures,
                                                     const std::filesystem::path& folder);

}  // namespace rocking::program
