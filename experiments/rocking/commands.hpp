#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"
#include "program.hpp"
#include "rocking/study/study.hpp"

namespace rocking::program {

/// The command from the command line, ready to be executed.
using Action = std::function<ExitCode()>;

/// add_X adds the command X to `app`; parsing a command line with X sets `action`. Each is defined in X_command.cpp,
/// which has no header of its own.
void add_run(CLI::App& app, Action& action, const ProcessPool& pool);
void add_resume(CLI::App& app, Action& action, const ProcessPool& pool);
void add_status(CLI::App& app, Action& action);
void add_merge(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
/// The command of a study of the list.
void add_study(CLI::App& app, Action& action, const Study& study);
void add_figure(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_trajectory(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);

}  // namespace rocking::program
