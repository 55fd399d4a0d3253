#pragma once

#include <string>
#include <vector>

#include "campaign.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking::program {

/// Prints on standard error what a user should know of the ground motions of an experiment before it runs, a line each:
/// warnings of their readers, and the motions that do not lift the block at any scale of the run.
void tell_ground_motion_notes(const Experiment& experiment);

/// What is suspicious in an experiment that has not been run.
[[nodiscard]] std::vector<Finding> findings_before_run(const Experiment& experiment);

/// Prints a warning for each on standard error.
void tell(const std::vector<Finding>& findings);

/// Prints on standard error the notes and the suspicious numbers of an experiment; the run itself counts its clamps.
void tell_notes(const Experiment& experiment);

/// All of them below how its ground motions were read.
[[nodiscard]] std::string checked_text(const Experiment& experiment);

/// Prints what a run would do, with its time.
[[nodiscard]] ExitCode show_plan(const Experiment& experiment, const std::optional<Shard>& shard,
                                 const ExecutionOptions& execution);

/// Adds `--status`, which goes with none of the options that the command has.
CLI::Option* add_status(CLI::App& command, std::string& folder);

/// Prints the progress of the run in a folder.
[[nodiscard]] ExitCode show_status(const std::string& folder, const Loudness& loudness);

}  // namespace rocking::program
