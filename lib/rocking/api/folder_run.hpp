#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/api/run_folder.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/report.hpp"
#include "rocking/plan/plan.hpp"

namespace rocking {

void say_nothing(const std::string& notice);

/// A run in a folder that is claimed. The store may lack realisations.
struct FolderRun {
  RunFolder folder;
  Experiment experiment;
  Store store;
  std::optional<std::filesystem::path> damaged_file = {};  ///< of a store that was mended: where it is now
};

/// What a run in a folder takes from its caller: no field changes a result.
struct FolderMeans {
  unsigned threads = 1;
  bool page = true;                               ///< whether a page will be drawn
  bool repair = true;                             ///< otherwise a damaged store is an error
  bool is_limited = false;                        ///< ends early at a time that is not known here, and so its needs
  std::optional<std::uint64_t> free_memory = {};  ///< [bytes]; absent: not known
  Tell tell = say_nothing;                        ///< what every caller should know
  Tell remark = say_nothing;                      ///< what a caller may leave out
  std::function<void(const Plan&)> on_plan = {};  ///< of a new run, before anything is written
};

/// What is asked of a new run.
struct NewRun {
  std::filesystem::path files = ".";  ///< folder of the files that the experiment names
  std::optional<Shard> shard = {};    ///< absent: all of it
  bool overwrite = false;             ///< a run in the folder is replaced when the new one is complete
};

/// Begins a run in a folder, which is created if necessary. Throws FolderError if the folder contains a run that is not to
/// be replaced, or another run is at work in it; std::system_error with the path where it cannot be used, or if the memory
/// or the disk is too small.
[[nodiscard]] FolderRun begin_run(const std::filesystem::path& folder, const Experiment& experiment,
                                  const NewRun& asked, const FolderMeans& means);

/// Goes on with a run, after a damaged store was mended and what a killed process left was completed. `extension`: a
/// larger number of realisations, or further levels of the sweep; such a run replaces a finished one when it is complete.
/// Throws FolderError if there is no run, if it was begun with another results version, if it cannot be extended so, or if
/// another run is at work in the folder; otherwise as begin_run and as a store that is opened.
[[nodiscard]] FolderRun resume_run(const std::filesystem::path& folder, const Overrides& extension,
                                   const FolderMeans& means);

/// Begins a run, or goes on with the one that the folder has of the same experiment, also of one with fewer realisations
/// as long as no report of it is there. Throws FolderError if it has another run; otherwise as the two.
[[nodiscard]] FolderRun begin_or_continue_run(const std::filesystem::path& folder, const Experiment& experiment,
                                              const NewRun& asked, const FolderMeans& means);

/// Joins the parts of a divided run, in a folder of its own, where it replaces an earlier run when it is complete
/// (`overwrite`). Parts may overlap if their common realisations agree. Throws FolderError if they do not, if the parts
/// are not of one experiment and of this results version, if the folder is one of them or contains a run that is not to be
/// replaced; nothing is written then. Otherwise as begin_run.
[[nodiscard]] FolderRun merge_runs(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& parts,
                                   bool overwrite, const Tell& tell = say_nothing);

/// The report of a finished run. Throws base::FolderError if there is none, or if it cannot be read; base::InputError with
/// file and line where it is none, or if it is that of another run.
[[nodiscard]] Report report_in(const RunFolder& folder);

/// Runs the realisations that are missing. A shard that is complete then replaces an earlier one in its folder.
[[nodiscard]] RunEnd run_in_folder(FolderRun& run, const RunOptions& options);

/// The result of a complete run. Throws sqlite::UnusableFile if the store lacks a realisation, base::Stopped if it is
/// asked to stop.
[[nodiscard]] ExperimentResult complete_result(const FolderRun& run, const base::ManyParts& how = {});

}  // namespace rocking
