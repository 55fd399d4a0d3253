#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/api/trajectory.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/stats/interval.hpp"

/// Checks of runs, of the random numbers and of the machine, and intervals of a probability.
namespace rocking {

/// A realisation that was run again has another result than the one that is stored.
class DifferentBits : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a check of a run has found.
struct RunCheck {
  std::uint64_t checked = 0;    ///< realisations, or repetitions, that were run again
  std::uint64_t different = 0;  ///< of them
  /// What differs, in words: of the first few.
  std::vector<std::string> findings;
};

/// Runs realisations of a run again and compares them with the stored ones to the bit: all of them, or about `sample`,
/// evenly spaced. Uses `threads`, `on_progress` and `stop` of the execution. Throws base::Stopped if it is asked to
/// stop.
[[nodiscard]] ROCKING_API RunCheck verify(const StoredRun& stored, std::optional<std::uint64_t> sample = {},
                                          const Execution& execution = {});

/// The same of the run in a folder, with its report where there is one, which must follow from the realisations. Without a
/// store the experiment of the report is run again, and there is no `sample`. Throws base::InputError with file and line
/// where the report is none, and otherwise as open_run.
[[nodiscard]] ROCKING_API RunCheck verify(const std::filesystem::path& folder, std::optional<std::uint64_t> sample = {},
                                          const Execution& execution = {});

/// Checks a report (`rocking.report/1`) without the store of its run: runs its experiment again and compares all that
/// follows from it; `checked` counts the realisations. `files` is the folder of the ground motions that the experiment
/// names. Where the report's experiment does not have the digest that the report states, nothing is run. Uses `threads`,
/// `on_progress` and `stop` of the execution. Throws base::InputError where the text is no report,
/// std::system_error with the path where a file that the experiment names cannot be read, and base::Stopped if it is
/// asked to stop.
[[nodiscard]] ROCKING_API RunCheck verify_report(std::string_view report, const std::filesystem::path& files = ".",
                                                 const Execution& execution = {});

/// State of the run in a folder.
struct RunStatus {
  std::string state;         ///< running, stopped or finished
  std::string part;          ///< `2/5` of a shard; empty: the whole
  std::uint64_t done = 0;    ///< realisations
  std::uint64_t all = 0;     ///< of the experiment, or of the shard
  std::uint64_t failed = 0;  ///< of those that are done: stopped, or ended by Painleve's paradox
  bool replaces = false;     ///< will replace an earlier run in the folder
  double rate = 0.0;         ///< realisations per second of the active run; 0 if none is active or it has just started

  [[nodiscard]] std::uint64_t missing() const { return all - done; }
};

/// Reads the state of the run in a folder, of the one that replaces it if there is one; also while it is in progress.
/// Throws FolderError if there is none, or if a file that the experiment names cannot be read; otherwise as open_run.
[[nodiscard]] ROCKING_API RunStatus status_of(const std::filesystem::path& folder);

/// A state in words, as `rocking run --status` prints it.
[[nodiscard]] ROCKING_API std::string describe(const RunStatus& status, const std::filesystem::path& folder);

/// The same as JSON text, as with `--json`.
[[nodiscard]] ROCKING_API std::string describe_as_json(const RunStatus& status);

/// The trajectory of a realisation of a run, checked against its digest. Throws base::InputError if the run has no such
/// realisation, DifferentBits if this version gives it another result, and otherwise as trajectory().
[[nodiscard]] ROCKING_API Trajectory replay(const StoredRun& stored, const TrajectoryRequest& request = {},
                                            const Execution& execution = {});

/// The same of the run in a folder, of which only that realisation is read. Throws base::FolderError if there is no run, or
/// no such realisation in it.
[[nodiscard]] ROCKING_API Trajectory replay(const std::filesystem::path& folder, const TrajectoryRequest& request = {},
                                            const Execution& execution = {});

/// Version, source, compiler and flags of this library.
[[nodiscard]] ROCKING_API base::BuildInfo build_info();

/// How many realisations a thread advances side by side, and with which instructions: `8, AVX-512`.
[[nodiscard]] ROCKING_API std::string lanes_in_use();

/// Examines the arithmetic of this machine, as `rocking doctor` does: if all checks pass, results have the same bits as
/// on other machines.
[[nodiscard]] ROCKING_API std::vector<base::ArithmeticCheck> check_arithmetic();

/// Two-sided confidence intervals of a probability, as in reports: within [0, 1], and [0, 1] without trials. `confidence`
/// is at least 1e-6 and below 1. They throw base::InputError for another one, for more than 1e9 trials, or for more
/// successes than trials.
///
/// Exact interval: covers the true value at least as often as promised.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] ROCKING_API stats::Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials,
                                                          double confidence = 0.95);

/// Score interval: narrower, covers the true value as often as promised on average over it.
/// Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209-212.
[[nodiscard]] ROCKING_API stats::Interval wilson(std::uint64_t successes, std::uint64_t trials,
                                                 double confidence = 0.95);

}  // namespace rocking
