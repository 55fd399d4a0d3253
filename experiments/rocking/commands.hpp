#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "crew.hpp"
#include "exit_code.hpp"

namespace rocking::program {

/// The command that was given, ready to be carried out.
using Action = std::function<ExitCode()>;

/// Each function adds its command to `app`. Parsing a command line that names it sets `action`.
void add_run(CLI::App& app, Action& action, const Crew& crew);
void add_resume(CLI::App& app, Action& action, const Crew& crew);
void add_status(CLI::App& app, Action& action);
void add_merge(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_bifurcation(CLI::App& app, Action& action);
void add_cost(CLI::App& app, Action& action);
void add_fragility(CLI::App& app, Action& action);
void add_figure(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_trajectory(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_check_normal(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);

}  // namespace rocking::program
