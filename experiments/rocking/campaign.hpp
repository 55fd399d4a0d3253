#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"
#include "output.hpp"
#include "process_pool.hpp"
#include "rocking/api/folder_run.hpp"

namespace rocking::program {

/// Whether a run ends with a page, report.html.
enum class PageChoice : std::uint8_t { drawn, omitted };

/// Options that `run`, `resume`, `merge` and `verify` have in common.
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

/// What a run in a folder takes from this process.
[[nodiscard]] FolderMeans means_of(const ExecutionOptions& execution);

/// Runs the realisations that the store lacks. If all are then present, writes the report and prints the table;
/// otherwise prints how to continue.
[[nodiscard]] ExitCode run_to_end(FolderRun run, const ExecutionOptions& execution);

/// The same of a run that gets no further realisations: one whose parts were merged.
[[nodiscard]] ExitCode write_merged(FolderRun run, const ExecutionOptions& execution);

/// Facts of this process, at this time.
[[nodiscard]] SystemFacts system_facts(unsigned threads);

}  // namespace rocking::program
