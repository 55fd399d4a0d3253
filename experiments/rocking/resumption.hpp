#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "exit_code.hpp"

namespace rocking::program {

/// A run that goes on.
struct ResumeRequest {
  std::string folder;
  std::optional<std::string> realisations;  ///< of the extended run
  std::vector<double> levels;               ///< further intensities of the extended run
  ExecutionOptions execution;
};

/// Runs what is missing, after a damaged store was mended, and writes the results.
[[nodiscard]] ExitCode resume_run(const ResumeRequest& request);

}  // namespace rocking::program
