#include "campaign.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "drawing.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

using Clock = std::chrono::steady_clock;

/// Work that a kill may lose. A commit takes less than a thousandth of it (reports/evidence/scale.md).
constexpr std::chrono::milliseconds between_commits(100);

/// How a run ended, and how long it took.
struct TimeSlice {
  RunEnd end;
  double duration_s = 0.0;
};

/// Estimate for the current condition of a run in progress, for display only: it counts the realisations of this
/// session, in the order in which threads finish.
class RunningEstimate {
 public:
  explicit RunningEstimate(const Experiment& experiment) : experiment_(&experiment) {}

  void add(std::size_t condition, const std::vector<Summary>& summaries) {
    condition_ = condition;
    for (const Summary& summary : summaries) ++counts_[condition][summary.mode];
  }

  /// The condition of the last add(), its most frequent response and Wilson's 95 % interval: `amplitude 4.2: (1,3) 69 %
  /// [60, 77] of 100`. Empty before the first add().
  [[nodiscard]] std::string text() const {
    const auto found = counts_.find(condition_);
    if (found == counts_.end()) return "";
    std::uint64_t number = 0;
    for (const auto& [mode, count] : found->second) number += count;
    const auto& [mode, count] =
        *std::ranges::max_element(found->second, {}, [](const auto& entry) { return entry.second; });
    const std::string name = values_of(experiment_->conditions[condition_].parameters);
    const stats::Interval interval = stats::wilson({.successes = count, .trials = number}, 0.95);
    return fmt::format("{}: {} {} of {}, {} % {}", name.empty() ? "so far" : name, to_string(mode), count, number,
                       per_cent(static_cast<double>(count) / static_cast<double>(number), 0), per_cent(interval, 0));
  }

 private:
  const Experiment* experiment_;
  std::size_t condition_ = 0;  ///< of the last add()
  std::map<std::size_t, std::map<section::ResponseMode, std::uint64_t>> counts_;
};

RunOptions options_of(const Store& store, const ExecutionOptions& execution) {
  RunOptions options;
  options.threads = execution.threads;
  options.stop_requested = &stop_on_interrupt();
  options.commit_is_due = [last = Clock::now()]() mutable {
    if (Clock::now() - last < between_commits) return false;
    last = Clock::now();
    return true;
  };
  if (execution.pool.start_workers) {
    Identity identity = store.identity();
    identity.code = base::code_identity();  // of the running processes, whichever program created the store
    options.pair_runner = execution.pool.start_workers(identity, execution.threads);
  }
  return options;
}

TimeSlice work(FolderRun& run, const ExecutionOptions& execution) {
  Progress progress(suitable_progress_style(execution.loudness), "realisations");
  RunningEstimate estimate(run.experiment);
  TimeSlice slice{};
  ProgressFile file(run.folder.progress_path());
  RunOptions options = options_of(run.store, execution);
  options.on_realisations = [&](std::size_t condition, const auto& summaries) { estimate.add(condition, summaries); };
  options.on_progress = [&](std::uint64_t done, std::uint64_t all) {
    progress.show(done, all, [&] { return estimate.text(); });
    file.note(done, all);
  };
  std::optional<TimeLimit> limit;
  if (execution.max_time) limit.emplace(*execution.max_time);
  try {
    slice.end = run_in_folder(run, options);
  } catch (const std::system_error&) {
    print_notice(
        fmt::format("stored realisations are kept; when the cause is removed, `rocking resume {}` continues the run",
                    shell_word(run.folder.name())));
    throw;
  }
  slice.duration_s = progress.elapsed();
  return slice;
}

ExitCode explain_stop(const FolderRun& run) {
  const Completeness reached = completeness(run.experiment, run.store);
  const bool interrupted = why_stopped() == StopReason::signal;
  print_notice(fmt::format("{}; {} of {} realisations are done and kept. `rocking resume {}` continues the run{}",
                           interrupted ? "interrupted" : "the time limit was reached", reached.done, reached.all,
                           shell_word(run.folder.name()),
                           run.folder.has_earlier_run() ? ". Until it is complete the earlier run is kept" : ""));
  return interrupted ? ExitCode::interrupted : ExitCode::stopped_early;
}

ExitCode explain_shard(const RunFolder& folder, const Shard& shard) {
  print_notice(fmt::format(
      "shard {} of {} is done; when the other shards are done too, `rocking resume DIR {} ...` writes the report",
      shard.part, shard.parts, shell_word(folder.name())));
  return ExitCode::done;
}

void write_unless_stopped(const std::filesystem::path& path, const std::function<void(const TextSink&)>& write) {
  write_atomically(path, [&write](const TextSink& sink) {
    write([&sink, stop = stop_on_signal()](std::string_view piece) {
      stop.check();
      sink(piece);
    });
  });
}

/// Announces the page and the time that it took, because a user may wonder what a finished run still does.
std::vector<analysis::Drawing> draw_page(const RunFolder& folder, const Report& report, const Loudness& loudness) {
  if (!loudness.quiet) print_notice("drawing the page; --no-page omits it");
  const Clock::time_point start = Clock::now();
  std::vector<analysis::Drawing> failures = write_page(folder, report);
  if (!loudness.quiet) {
    const std::chrono::duration<double> took = Clock::now() - start;
    print_notice(fmt::format("page drawn in {}", duration_in_words(took.count())));
  }
  return failures;
}

/// The system error that `act` throws; null if none. The caller prints the table before it reports the error.
std::exception_ptr failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::system_error&) {
    return std::current_exception();
  }
  return nullptr;
}

/// Writes the report and its page, replaces an earlier run by them, and prints the table. Without a page, that of an
/// earlier report in the folder is removed.
ExitCode write_results(FolderRun& run, ExperimentResult result, const SystemFacts& system,
                       const ExecutionOptions& how) {
  RunFolder& folder = run.folder;
  const Report report = report_of(std::move(run.experiment), std::move(result), system);
  const auto write = [&](const TextSink& sink) { report_document().write(sink, report); };
  std::exception_ptr failure;
  std::vector<analysis::Drawing> failures;
  try {
    write_unless_stopped(folder.report_path(), write);
    failure = failure_of([&] {
      if (how.page == PageChoice::drawn) {
        failures = draw_page(folder, report, how.loudness);
      } else {
        std::filesystem::remove(folder.page_path());
      }
      folder.install_replacement();
    });
  } catch (const base::Stopped&) {
    print_notice(fmt::format(
        "interrupted; all realisations are done and kept. `rocking resume {}` writes the report and its page",
        shell_word(folder.name())));
    return ExitCode::interrupted;
  }
  if (how.loudness.json) {
    print_result(write);
  } else {
    std::string where = fmt::format("report: {}\n", folder.report_path().string());
    if (how.page == PageChoice::drawn) where += fmt::format("page: {}\n", folder.page_path().string());
    TableLook look = table_look();
    if (how.extent == Extent::one_screen) look.most_rows = most_screen_rows;
    print_text(run_table(report, look) + where);
  }
  if (failure) std::rethrow_exception(failure);
  return tell(failures, no_page_picture, PictureRole::addition);
}

}  // namespace

SystemFacts system_facts(unsigned threads) {
  return {.build = base::build_info(), .machine = machine_description(), .start = utc_now(), .threads = threads};
}

FolderMeans means_of(const ExecutionOptions& execution) {
  const bool quiet = execution.loudness.quiet;
  return {.threads = execution.threads,
          .page = execution.page == PageChoice::drawn,
          .is_limited = execution.max_time.has_value(),
          .free_memory = available_memory(),
          .tell = print_notice,
          .remark = [quiet](const std::string& text) {
            if (!quiet) print_notice(text);
          }};
}

ExitCode run_to_end(FolderRun run, const ExecutionOptions& execution) {
  SystemFacts system = system_facts(execution.threads * execution.pool.processes);
  if (run.store.journalling() == Journalling::rollback) {
    print_notice(
        fmt::format("{}: this file system has no shared memory for SQLite's log; a slower journal is used, and "
                    "commands that read the run may have to wait for a moment",
                    run.folder.name()));
  }
  const TimeSlice slice = work(run, execution);
  if (slice.end == RunEnd::stopped) return explain_stop(run);
  if (const auto& shard = run.store.identity().shard) return explain_shard(run.folder, *shard);
  system.duration_s = slice.duration_s;
  std::optional<ExperimentResult> result;
  try {
    result = complete_result(run, {.threads = execution.threads, .stop = stop_on_signal()});
  } catch (const base::Stopped&) {
    return explain_stop(run);
  }
  const ExitCode code = write_results(run, *std::move(result), system, execution);
  if (code == ExitCode::done && !execution.loudness.quiet) {
    print_notice(fmt::format("{} on {}", duration_in_words(system.duration_s), counted(system.threads, "thread")));
  }
  return code;
}

ExitCode write_merged(FolderRun run, const ExecutionOptions& execution) {
  const Completeness found = completeness(run.experiment, run.store);
  if (found.done == found.all) {
    return write_results(run, complete_result(run, {.threads = execution.threads, .stop = stop_on_signal()}),
                         system_facts(1), execution);
  }
  const bool replaces = run.folder.has_earlier_run();
  if (!replaces) run.folder.install_replacement();
  print_notice(fmt::format("{} of {} realisations are present; `rocking resume {}` runs the rest{}", found.done,
                           found.all, shell_word(run.folder.name()),
                           replaces ? ". Until then the earlier run is kept" : ""));
  return ExitCode::stopped_early;
}

}  // namespace rocking::program
