#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "drawing.hpp"
#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/figures/trajectory_file.hpp"
#include "rocking/scene/hazard.hpp"

namespace rocking::program {

/// The hazard curve of a command: `--hazard` names its file, `--years`, `--imt`, `--site` and `--statistic` say what the
/// file leaves open, and which of its curves is meant.
class HazardFile {
 public:
  /// `effect`: what the curve gives, for the help.
  void add_to(CLI::App& command, const std::string& effect);

  [[nodiscard]] bool is_given() const { return !file_.empty(); }
  /// Absent if no file is named. Throws MissingInput, and base::InputError as hazard_curve().
  [[nodiscard]] std::optional<HazardCurve> read() const;

 private:
  std::string file_;
  HazardReading reading_;
  std::vector<double> site_;
};

/// What is written again of a finished run.
struct ReportRequest {
  std::vector<std::string> paths;    ///< the folder of a run; or files that rocking printed
  std::string drawn;                 ///< folder for the figures of files
  analysis::Window window;           ///< of trajectories
  std::vector<std::string> formats;  ///< html, csv, gnuplot, latex, text
  HazardFile hazard;
  StyleRequest style;  ///< of the figures, not of the page
  Loudness loudness;
};

/// Writes page, figures and tables of a finished run, from its report.
[[nodiscard]] ExitCode report_again(const ReportRequest& request);

/// Draws files that rocking printed.
[[nodiscard]] ExitCode draw_files(const ReportRequest& request);

}  // namespace rocking::program
