#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "crew.hpp"
#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/experiment/store.hpp"
#include "rocking/report/write_report.hpp"
#include "run_folder.hpp"

namespace rocking::program {

/// How to work: what `run`, `resume` and `verify` have in common.
struct Labour {
  unsigned threads = 1;
  std::optional<double> max_time;  ///< stop cleanly after this long [s]
  Loudness loudness;
  Crew crew = {};
};

/// Adds `-j`, and `--max-time` where a run can go on later.
void add_threads(CLI::App& command, Labour& labour);
void add_max_time(CLI::App& command, Labour& labour);

/// Runs what the store lacks. When nothing is missing any more it writes the report and prints the table; otherwise it says
/// how to go on.
[[nodiscard]] ExitCode carry_through(RunFolder& folder, const experiment::Experiment& experiment,
                                     experiment::Store& store, const Labour& labour);

/// What a report says of where it was made, and how loudly that is told.
struct Conclusion {
  report::SystemFacts system;
  Loudness loudness;
};

/// Facts of this process, at this time.
[[nodiscard]] report::SystemFacts system_facts(unsigned threads);

/// The result of a run of which the store should hold every realisation. Throws sqlite::UnusableFile where it does not,
/// base::Stopped when a signal asks to stop.
[[nodiscard]] experiment::ExperimentResult complete_result(const RunFolder& folder,
                                                           const experiment::Experiment& experiment,
                                                           const experiment::Store& store);

/// Writes the report and its page, lets them take the place of an earlier run, and prints the table.
[[nodiscard]] ExitCode conclude(RunFolder& folder, const experiment::Experiment& experiment,
                                const experiment::ExperimentResult& result, const Conclusion& how);

}  // namespace rocking::program
