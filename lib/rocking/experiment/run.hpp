#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/experiment/store.hpp"
#include "rocking/lanes/kernels.hpp"

namespace rocking::experiment {

struct PairFlow;
struct RunOptions;

/// Who runs the pairs of an experiment until none is left or it is asked to stop.
using Workforce = std::function<void(const Experiment&, const RunOptions&, const PairFlow&)>;

/// How to work through an experiment. Nothing here changes a result.
struct RunOptions {
  unsigned threads = 1;
  /// Called now and then, from one thread at a time, with the realisations done so far of all.
  std::function<void(std::uint64_t done, std::uint64_t all)> on_progress;
  /// Looked at within realisations too; those under way are left unfinished.
  base::StopRequest stop_requested = nullptr;
  /// Called before `on_progress`, with what was just put into the store.
  std::function<void(std::size_t condition, const std::vector<Summary>& summaries)> on_realisations = nullptr;
  /// Whether what was added since it last said so is to be made durable; asked after each pair. Empty: after a fixed number
  /// of strobe periods.
  std::function<bool()> commit_is_due = {};
  Workforce workforce = {};  ///< empty: `threads` threads of this process
  /// How many realisations each thread advances side by side, and with which instructions.
  lanes::Kernels lanes = lanes::available_kernels().back();
};

enum class RunEnd : std::uint8_t { complete, stopped };

/// Runs what the store lacks of the experiment, or of its shard, and puts it there.
[[nodiscard]] RunEnd run(const Experiment& experiment, Store& store, const RunOptions& options);

/// How far a store has come.
struct Completeness {
  std::uint64_t done = 0;
  std::uint64_t all = 0;  ///< realisations of the experiment, or of the store's shard
};
[[nodiscard]] Completeness completeness(const Experiment& experiment, const Store& store);

/// Realisations of the experiment, or of the store's shard, that the store lacks, in their order. Where intervals decide
/// how many are run: those up to the next look at them.
[[nodiscard]] std::vector<RealisationKey> missing_realisations(const Experiment& experiment, const Store& store);

/// The result of an experiment of which the store holds every realisation; absent where some are missing. It does not
/// depend on what was computed where and when. Throws sqlite::UnusableFile where the store has rows of other realisations,
/// base::Stopped once it is asked to stop.
[[nodiscard]] std::optional<ExperimentResult> result_of(const Experiment& experiment, const Store& store,
                                                        base::StopRequest stop = {});

/// Both at once, with a store in memory. Absent if it was asked to stop before the end.
[[nodiscard]] std::optional<ExperimentResult> run(const Experiment& experiment, const RunOptions& options);

}  // namespace rocking::experiment
