#pragma once

#include <string>
#include <vector>

#include "drawing.hpp"
#include "exit_code.hpp"
#include "hazard_file.hpp"
#include "output.hpp"

namespace rocking::program {

/// What is written again of a finished run.
struct ReportRequest {
  std::string folder;
  std::vector<std::string> formats;  ///< html, csv, gnuplot, latex, text
  HazardFile hazard;
  StyleRequest style;  ///< of the figures, not of the page
  Loudness loudness;
};

/// Writes page, figures and tables of a finished run, from its report.
[[nodiscard]] ExitCode report_again(const ReportRequest& request);

}  // namespace rocking::program
