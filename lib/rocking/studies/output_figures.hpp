#pragma once

#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/figures/trajectory_file.hpp"

namespace rocking::analysis {

/// A file that a command of rocking wrote or printed.
struct OutputFile {
  std::string path;
  std::string text;
};

/// The figures of the outputs of `rocking trajectory`, `replay`, `bifurcation`, `cost --json`, `fragility --json`,
/// `rare`, `infer` and `check-normal --json`. Each trajectory with a history has `time_history`; several of them also
/// have `responses`; all trajectories together have `poincare`. The other outputs have their own figures. Repeated
/// names are numbered. Throws base::InputError with the path of a file that is none of these.
[[nodiscard]] std::vector<Figure> output_figures(const std::vector<OutputFile>& files, const Window& window);

}  // namespace rocking::analysis
