#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::program {

/// Adds the argument EXPERIMENT.
void add_experiment(CLI::App& command, std::string& file);
/// Adds `--skip-unreadable`.
void add_skip_unreadable(CLI::App& command, Overrides& overrides);
/// Adds `--seed`.
void add_seed(CLI::App& command, Overrides& overrides);

/// Reads a file or, if the path is `-`, standard input to its end; file names in the latter are relative to the current
/// folder. Throws MissingInput where it cannot be read.
[[nodiscard]] ExperimentText load_experiment_text(const std::string& path);

/// Reads the experiment in it. Throws base::InputError, or MissingInput where it, or a file that it names, cannot be
/// read.
[[nodiscard]] Experiment load_experiment(const ExperimentText& source, const Overrides& overrides = {});
[[nodiscard]] Experiment load_experiment(const std::string& path, const Overrides& overrides = {});

/// Carries out a check of the experiment; its problems get the file and the line.
template <class Check>
void check_source(const ExperimentText& source, Check check) {
  try {
    check();
  } catch (const base::InputError& error) {
    throw located(error, source.text, source.name);
  }
}

}  // namespace rocking::program
