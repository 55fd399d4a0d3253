#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::report {

/// Values from the command line that replace those of the file. Checked as if they stood there.
struct Overrides {
  std::optional<std::string> seed;          ///< `--seed`
  std::optional<std::string> realisations;  ///< `--realisations`
};

/// Reads an experiment file (`rocking.experiment/1`, lib/docs/formats.md), works out its sweep and checks every condition.
/// Throws InputError with all problems found.
[[nodiscard]] experiment::Experiment read_experiment(std::string_view text, const Overrides& overrides = {});

/// The same from a file. Throws std::system_error with the path where it cannot be read.
[[nodiscard]] experiment::Experiment read_experiment_file(const std::filesystem::path& path,
                                                          const Overrides& overrides = {});

}  // namespace rocking::report
