#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/trajectory_file.hpp"

namespace rocking::analysis {

/// A file that a command of rocking wrote or printed.
struct OutputFile {
  std::string path;
  std::string text;
};

/// The figures of what `rocking trajectory`, `replay`, `bifurcation`, `cost --json`, `fragility --json` and `check-normal --json`
/// print: of each trajectory with a history `time_history`; of several of them also `responses`; of all trajectories together
/// `poincare`; of the others their own. Names that would stand twice are numbered. Throws base::InputError with the path
/// of a file that is none of these.
[[nodiscard]] std::vector<Figure> output_figures(const std::vector<OutputFile>& files, const Window& window);

}  // namespace rocking::analysis
