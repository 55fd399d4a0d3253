#pragma once

#include <cstdint>
#include <optional>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"
#include "output.hpp"
#include "process_pool.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/store.hpp"

namespace rocking::program {

/// Whether a run ends with a page, report.html.
enum class PageChoice : std::uint8_t { drawn, omitted };

/// Options that `run`, `resume` and `verify` have in common.
struct ExecutionOptions {
  unsigned threads = 1;
  std::optional<double> max_time;  ///< stop cleanly after this long [s]
  Loudness loudness;
  ProcessPool pool = {};
  PageChoice page = PageChoice::drawn;
  Extent extent = Extent::one_screen;
};

/// Adds `-j`, and `--max-time` for commands whose run can be resumed.
void add_threads(CLI::App& command, ExecutionOptions& execution);
void add_max_time(CLI::App& command, ExecutionOptions& execution);
/// Adds `--no-page`.
void add_page_choice(CLI::App& command, PageChoice& page);

/// Runs the realisations that the store lacks. If all are then present, writes the report and prints the table;
/// otherwise prints how to continue.
[[nodiscard]] ExitCode run_to_end(RunFolder& folder, const Experiment& experiment, Store& store,
                                  const ExecutionOptions& execution);

/// The `system` part of a report, how much is printed, and whether there is a page.
struct ResultWriting {
  SystemFacts system;
  Loudness loudness;
  PageChoice page = PageChoice::drawn;
  Extent extent = Extent::one_screen;
};

/// Facts of this process, at this time.
[[nodiscard]] SystemFacts system_facts(unsigned threads);

/// The result of a complete run. Throws sqlite::UnusableFile if the store lacks a realisation,
/// base::Stopped when a signal asks to stop.
[[nodiscard]] ExperimentResult complete_result(const RunFolder& folder, const Experiment& experiment,
                                               const Store& store);

/// Writes the report and its page, replaces an earlier run by them, and prints the table. Without a page, that of an
/// earlier report in the folder is removed.
[[nodiscard]] ExitCode write_results(RunFolder& folder, const Experiment& experiment, ExperimentResult result,
                                     const ResultWriting& how);

}  // namespace rocking::program
