#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/experiment.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/realisation_key.hpp"

/// Runs of experiments.
namespace rocking {

class Store;

/// What the caller of a run answers to a report of progress.
enum class Decision : std::uint8_t { proceed, stop };

/// How an experiment is run. No field changes a realisation.
struct Execution {
  unsigned threads = 1;  ///< at least 1
  /// Called from time to time, by one thread at a time, with the numbers of finished realisations and of all. Studies may
  /// not know the second one at first; it is 0 then.
  std::function<Decision(std::uint64_t done, std::uint64_t all)> on_progress = {};
  /// A flag that stops the run when it is set, by any thread or a signal handler; looked at within realisations too. It
  /// must outlive the run, which sets it where on_progress says stop. Null: none.
  std::atomic<bool>* stop = nullptr;
  /// Clocks of the caller, since the library reads none: wall-clock time since some instant, which several threads ask for,
  /// and processor time of the calling thread [s]. A study that needs one says so.
  std::function<double()> elapsed_seconds = {};
  std::function<double()> processor_seconds = {};
  /// Folder for the store of the realisations, `realisations.sqlite`, which the program reads and resumes; created if
  /// necessary. A run in a folder that has realisations of the same experiment continues it, also of one with fewer
  /// realisations as long as no report of it is there. Runs in one folder exclude each other. Empty: in memory.
  std::filesystem::path folder = {};
  /// Whether a damaged store is replaced by one with its intact realisations; the others are run again.
  bool repair = false;
  /// Folder of the ground motions that the experiment names; kept in the store, so that the run can be resumed.
  std::filesystem::path files = ".";
  /// The part that is run of an experiment divided among processes or machines; merge() joins the folders. A part has
  /// counts and no result. Absent: all of it.
  std::optional<Shard> shard = {};
};

/// What is known of an experiment after a run.
struct RunResult {
  std::optional<ExperimentResult> result;  ///< absent if the run was stopped before the end, and of a part
  std::uint64_t done = 0;                  ///< realisations that are finished
  std::uint64_t all = 0;                   ///< realisations of the experiment, or of the part
  /// Finished realisations by response mode, for each condition; also of a run that was stopped.
  std::vector<std::map<section::ResponseMode, std::uint64_t>> counts;
  std::shared_ptr<const Store> store;                      ///< the realisations
  std::optional<std::filesystem::path> damaged_file = {};  ///< of a store that was repaired: where it is now

  [[nodiscard]] bool is_complete() const { return result.has_value(); }
};

/// Runs the realisations of an experiment that are not done yet. The result depends on the experiment alone, not on
/// threads, interruptions or the machine; calls from several threads are independent. Throws base::InputError if a
/// condition is not valid, if the folder has realisations of another experiment, or if an experiment without text is to
/// be kept in a folder; base::UnusableFile if the store is damaged and is not to be
/// repaired; std::system_error with the path where the folder cannot be used or another run is at work in it.
[[nodiscard]] ROCKING_API RunResult run(const Experiment& experiment, const Execution& execution = {});

/// The run in a folder, with its experiment.
struct StoredRun {
  Experiment experiment;
  RunResult run;
};

/// Reads the folder that run(), or the program, has filled. Throws std::system_error with the path where there is none,
/// base::UnusableFile if the store is damaged, and base::InputError if a file that the experiment names has changed, or if
/// a report.json in the folder is of another experiment.
[[nodiscard]] ROCKING_API StoredRun open_run(const std::filesystem::path& folder, unsigned threads = 1);

/// The realisations of a run as bytes, and the run of this experiment with these realisations: to send it to another
/// process. Throws base::InputError if the bytes are of another experiment, and base::UnusableFile if they are of none.
[[nodiscard]] ROCKING_API std::string bytes_of(const RunResult& run);
[[nodiscard]] ROCKING_API RunResult run_of(const Experiment& experiment, const std::string& bytes);

/// Goes on with the run in a folder, after a damaged store was mended. `extension`: more realisations, or further levels of
/// the sweep; such a run replaces a complete one, whose report it removes, when it is complete itself. Throws
/// base::FolderError if there is no run, if it cannot be extended so, or if another run is at work in the folder; otherwise
/// as run and open_run. Uses `threads`, `on_progress` and `stop` of the execution.
[[nodiscard]] ROCKING_API StoredRun resume(const std::filesystem::path& folder, const Overrides& extension = {},
                                           const Execution& execution = {});

/// Joins the parts of a divided run, folders that run() or the program has filled, in a new folder; the run there has no
/// result while realisations are missing. Parts may overlap if their common realisations agree. Throws base::InputError
/// if the folder already contains a run, if the parts are not of one experiment and of this results version, or if they
/// contradict each other (nothing is kept then), std::system_error if another run is at work in the folder, and otherwise
/// as open_run.
[[nodiscard]] ROCKING_API StoredRun merge(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& parts);

/// One finished realisation of a run.
struct RunRealisation {
  RealisationKey key;
  section::ResponseMode mode;
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  bool left_ground = false;
  bool was_past_balance = false;                       ///< abs(Theta) reached 1
  std::optional<dynamics::Side> overturned_side = {};  ///< absent if it did not overturn
  double margin = 0.0;                                 ///< of the classification
  PeakValues peaks;
};

/// The finished realisations of a run, in the order of conditions and of realisations; also of one that was stopped.
/// Throws base::UnusableFile if the store is damaged.
[[nodiscard]] ROCKING_API std::vector<RunRealisation> realisations_of(const RunResult& run);

/// What the report says of the machine and the time, which the library does not read itself.
struct Provenance {
  std::string machine = "unknown";             ///< processor and operating system
  std::string start = "1970-01-01T00:00:00Z";  ///< ISO 8601 in UTC
  double duration_s = 0.0;                     ///< [s]
  unsigned threads = 1;
};

/// The report of a complete run as JSON text (`rocking.report/1`). All but `system` has the same bytes as that of the
/// program; `input.experiment` of an experiment made in C++ is null. Throws std::invalid_argument if the run is not complete.
[[nodiscard]] ROCKING_API std::string report(const Experiment& experiment, const RunResult& run,
                                             const Provenance& provenance = {});

/// A complete run as text for a terminal, as the program prints it: a row for each condition, a column for each response
/// mode that occurs with its estimate and interval in per cent, then a line on each that needs attention. Lines have at
/// most `width` letters where a table can be that narrow. Throws std::invalid_argument if the run is not complete.
[[nodiscard]] ROCKING_API std::string table(const Experiment& experiment, const RunResult& run,
                                            std::size_t width = 120);

/// SHA-256 of the results of all realisations of a complete run, 64 hexadecimal digits: `result.digest` of the report.
/// Throws std::invalid_argument if the run is not complete.
[[nodiscard]] ROCKING_API std::string digest_of(const RunResult& run);

/// Numbers of conditions, realisations and periods of a run, its disk space and memory, which effects are on and, with a
/// clock, its time: from a sample of the realisations, which takes at most two seconds. Uses `threads`, `shard`, `stop` and
/// `elapsed_seconds` of the execution; writes nothing. Throws base::InputError if a condition or the shard is not valid,
/// and base::Stopped if it is asked to stop.
[[nodiscard]] ROCKING_API Plan plan(const Experiment& experiment, const Execution& execution = {});

/// A plan in words, as `rocking run --dry-run` prints it.
[[nodiscard]] ROCKING_API std::string describe(const Plan& plan);

/// The plan as JSON text, as with `--json`.
[[nodiscard]] ROCKING_API std::string describe_as_json(const Plan& plan);

/// What is checked of a block first, as `rocking validate` prints it: for each edge its distance from the centre of mass, R,
/// psi, p, the base acceleration of uplift, Housner's rate ratio, and whether the block slides before it rocks. Of the mean
/// blocks of all conditions.
[[nodiscard]] ROCKING_API std::string describe_block(const Experiment& experiment);

/// Files that were written.
struct Written {
  std::vector<std::filesystem::path> files;
  /// Reasons why pictures are missing, each once: gnuplot is not installed, or failed. Empty: all are there.
  std::vector<std::string> not_drawn;
};

}  // namespace rocking
