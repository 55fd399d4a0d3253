#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/difference.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

struct PairFlow;
struct RunOptions;

/// Runs the pairs of an experiment until there are none left or a stop is requested.
using PairRunner = std::function<void(const Experiment&, const RunOptions&, const PairFlow&)>;

/// How an experiment is run. No option changes a result.
struct RunOptions {
  unsigned threads = 1;
  /// Called from time to time, by one thread at a time, with the number of finished realisations and of all.
  std::function<void(std::uint64_t done, std::uint64_t all)> on_progress;
  /// Also checked within realisations; those in progress are abandoned.
  base::StopRequest stop_requested = nullptr;
  /// Called before `on_progress`, with the summaries that were just put into the store.
  std::function<void(std::size_t condition, const std::vector<Summary>& summaries)> on_realisations = nullptr;
  /// Called after each pair; returns whether the rows added since it last returned true are to be made durable. Empty:
  /// after a fixed number of strobe periods.
  std::function<bool()> commit_is_due = {};
  PairRunner pair_runner = {};  ///< empty: `threads` threads of this process
  /// Number of realisations that each thread advances at once, and the instruction set.
  lanes::Kernels lanes = lanes::available_kernels().back();
};

enum class RunEnd : std::uint8_t { complete, stopped };

/// Runs the realisations of the experiment, or of its shard, that the store lacks, and adds them to the store. Throws
/// base::InputError if a condition is not valid (check_experiment).
[[nodiscard]] RunEnd run(const Experiment& experiment, Store& store, const RunOptions& options);

/// How many realisations of an experiment are stored.
struct Completeness {
  std::uint64_t done = 0;
  std::uint64_t all = 0;  ///< realisations of the experiment or of the shard of the store
};
[[nodiscard]] Completeness completeness(const Experiment& experiment, const Store& store);

/// Realisations of the experiment, or of the shard of the store, that the store lacks, in order. If intervals determine
/// their number: those up to the next look.
[[nodiscard]] std::vector<RealisationKey> missing_realisations(const Experiment& experiment, const Store& store);

/// The result of an experiment whose realisations are all in the store; absent if some are missing. It does not depend
/// on where and when they were computed. Throws sqlite::UnusableFile if the store contains realisations that are not of
/// the experiment, and base::Stopped if it is asked to stop. `also`: called for each row by the thread that reads it, and
/// those of a condition are read by one.
[[nodiscard]] std::optional<ExperimentResult> result_of(const Experiment& experiment, const Store& store,
                                                        const base::ManyParts& how = {},
                                                        const Store::UseOfRow& also = {});

/// Runs an experiment with a store in memory and returns its result. Absent if it was asked to stop before the end.
[[nodiscard]] std::optional<ExperimentResult> run(const Experiment& experiment, const RunOptions& options);

struct Verification {
  std::uint64_t checked = 0;            ///< realisations that were run again
  std::uint64_t different = 0;          ///< of them
  std::vector<Difference> differences;  ///< the first few, in the order of their keys
};

/// Runs realisations of a store again and compares them with their rows to the bit: all of them, or about `sample`,
/// evenly spaced over the experiment.
[[nodiscard]] Verification verify(const Experiment& experiment, const Store& store,
                                  const std::optional<std::uint64_t>& sample, const RunOptions& options);

}  // namespace rocking
