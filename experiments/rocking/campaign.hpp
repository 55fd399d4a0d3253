#pragma once

#include "arguments.hpp"
#include "rocking/api/folder_run.hpp"

namespace rocking::program {

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
