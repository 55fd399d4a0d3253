#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/store/store_identity.hpp"
#include "rocking/study/study.hpp"

namespace rocking::program {

/// Processes and threads that run realisations.
struct ProcessPool {
  unsigned threads = 1;    ///< of each process, unless `-j` says otherwise
  unsigned processes = 1;  ///< that work together
  /// Sends the other processes the experiment, and returns the runner of pairs on all processes. Empty: no others.
  std::function<PairRunner(const Identity&, unsigned threads)> start_workers = {};
};

/// Executes the command line; `pool` runs the realisations. Errors are printed on standard error.
[[nodiscard]] ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool);

/// The command from the command line, ready to be executed.
using Action = std::function<ExitCode()>;

/// add_X adds the command X to `app`; parsing a command line with X sets `action`. Each is defined in X_command.cpp,
/// which has no header of its own.
void add_run(CLI::App& app, Action& action, const ProcessPool& pool);
void add_resume(CLI::App& app, Action& action, const ProcessPool& pool);
void add_verify(CLI::App& app, Action& action);
void add_archive(CLI::App& app, Action& action);
/// The command of a study of the list.
void add_study(CLI::App& app, Action& action, const Study& study);
void add_report(CLI::App& app, Action& action);
void add_trajectory(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);

}  // namespace rocking::program
