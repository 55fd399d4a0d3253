#include "campaign.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "interrupt.hpp"
#include "machine.hpp"
#include "page.hpp"
#include "progress.hpp"
#include "progress_file.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/experiment/noise_floor.hpp"
#include "rocking/experiment/run.hpp"
#include "rocking/report/files.hpp"
#include "rocking/report/mode_table.hpp"
#include "rocking/report/text_table.hpp"
#include "rocking/report/write_report.hpp"
#include "running_estimate.hpp"
#include "terminal.hpp"

namespace rocking::program {
namespace {

using Clock = std::chrono::steady_clock;

/// What a kill may cost. A commit takes less than a thousandth of it (lib/docs/scale.md).
constexpr std::chrono::milliseconds between_commits(100);

std::uint64_t unresolved_realisations(const experiment::ExperimentResult& result) {
  std::uint64_t count = 0;
  for (const auto& condition : result.conditions) {
    for (const auto& [mode, probability] : condition.modes) {
      if (mode.kind == section::ResponseKind::unresolved) count += probability.counts.successes;
    }
  }
  return count;
}

std::string_view spoken(experiment::ArithmeticNoise noise) {
  switch (noise) {
    case experiment::ArithmeticNoise::small: return "small compared with";
    case experiment::ArithmeticNoise::not_small: return "NOT small compared with";
    case experiment::ArithmeticNoise::undecided: return "too few reruns to compare with";
  }
  return "";
}

std::string noise_line(const std::optional<experiment::NoiseFloor>& floor) {
  if (!floor) return "";
  return fmt::format(
      "sensitivity to tolerance: {} of {} response modes change at a hundred times tighter tolerance [{:.1f}, {:.1f} "
      "%]; {} the "
      "narrowest "
      "half-width, {:.1f} %\n",
      floor->flips.successes, floor->flips.trials, 100.0 * floor->interval.low, 100.0 * floor->interval.high,
      spoken(floor->noise), 100.0 * floor->half_width);
}

/// A line on the responses that became what they are called within their sampled periods; empty if none did.
std::string late_settling_of(const experiment::ExperimentResult& result) {
  std::uint64_t count = 0;
  double least_held = 1.0;
  for (const auto& condition : result.conditions) {
    count += condition.validity.settled_late.count;
    least_held = std::min(least_held, condition.validity.least_held);
  }
  if (count == 0) return "";
  return fmt::format("settled late: {}, classified by the last {:g} % of their sampled periods or more\n",
                     counted(count, "realisation"), 100.0 * least_held);
}

/// `95 %`; where conditions differ in it, the words that say so.
std::string level_of(const experiment::Experiment& experiment) {
  const auto common = experiment::common_confidence(experiment);
  return common ? report::level_text(*common) + " %" : "(at the confidence of each condition)";
}

std::string summary_of(const experiment::Experiment& experiment, const experiment::ExperimentResult& result) {
  std::uint64_t realisations = 0;
  for (const auto& condition : result.conditions) realisations += condition.realisations;
  std::string text = experiment.title.empty() ? "" : experiment.title + "\n\n";
  text += report::mode_table(experiment, result, table_look());
  text += fmt::format("\nper cent of n realisations [simultaneous {} interval{}]; {}, {}, of which {} unresolved\n",
                      level_of(experiment),
                      experiment.conditions.front().until ? ", valid whenever the run stops" : "",
                      counted(result.conditions.size(), "condition"), counted(realisations, "realisation"),
                      unresolved_realisations(result));
  text += late_settling_of(result);
  return text + noise_line(experiment::noise_floor(result.conditions, experiment::highest_confidence(experiment)));
}

/// How a run ended, and how long it took.
struct Stretch {
  experiment::RunEnd end;
  double duration_s = 0.0;
};

experiment::RunOptions options_of(const experiment::Store& store, const Labour& labour) {
  experiment::RunOptions options;
  options.threads = labour.threads;
  options.stop_requested = &stop_on_interrupt();
  options.commit_is_due = [last = Clock::now()]() mutable {
    if (Clock::now() - last < between_commits) return false;
    last = Clock::now();
    return true;
  };
  if (labour.crew.hire) {
    experiment::Identity identity = store.identity();
    identity.code = code_identity();  // of the processes at work, whoever began the store
    options.workforce = labour.crew.hire(identity, labour.threads);
  }
  return options;
}

Stretch work(const RunFolder& folder, const experiment::Experiment& experiment, experiment::Store& store,
             const Labour& labour) {
  Progress progress(suitable_progress_style(labour.loudness), "realisations");
  RunningEstimate estimate(experiment);
  Stretch stretch{};
  ProgressFile file(folder.progress_path());
  experiment::RunOptions options = options_of(store, labour);
  options.on_realisations = [&](std::size_t condition, const auto& summaries) { estimate.add(condition, summaries); };
  options.on_progress = [&](std::uint64_t done, std::uint64_t all) {
    progress.show(done, all, [&] { return estimate.text(); });
    file.note(done, all);
  };
  std::optional<TimeLimit> limit;
  if (labour.max_time) limit.emplace(*labour.max_time);
  try {
    stretch.end = experiment::run(experiment, store, options);
  } catch (const std::system_error&) {
    print_notice(
        fmt::format("stored realisations are kept; when the cause is removed, `rocking resume {}` continues the run",
                    folder.name()));
    throw;
  }
  stretch.duration_s = progress.elapsed();
  return stretch;
}

ExitCode explain_stop(const RunFolder& folder, const experiment::Completeness& reached) {
  const bool interrupted = why_stopped() == StopReason::signal;
  print_notice(fmt::format("{}; {} of {} realisations are done and kept. `rocking resume {}` continues the run{}",
                           interrupted ? "interrupted" : "the time limit was reached", reached.done, reached.all,
                           folder.name(),
                           folder.has_earlier_run() ? ". Until it is complete the earlier run is kept" : ""));
  return interrupted ? ExitCode::interrupted : ExitCode::stopped_early;
}

ExitCode explain_shard(RunFolder& folder, const experiment::Shard& shard) {
  folder.install_replacement();
  print_notice(fmt::format(
      "shard {} of {} is done; when the other shards are done too, `rocking merge DIR {} ...` writes the report",
      shard.part, shard.parts, folder.name()));
  return ExitCode::done;
}

void write_unless_stopped(const std::filesystem::path& path, const std::function<void(const report::TextSink&)>& write) {
  report::write_atomically(path, [&write](const report::TextSink& sink) {
    write([&sink, stop = stop_on_signal()](std::string_view piece) {
      stop.check();
      sink(piece);
    });
  });
}

/// What the environment has against it; null where nothing. The table is printed before it is told.
std::exception_ptr failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::system_error&) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

void add_threads(CLI::App& command, Labour& labour) {
  command.add_option("-j,--threads", labour.threads, "Number of threads; changes the time, never the result")
      ->check(whole_number(1, 4096))
      ->capture_default_str()
      ->type_name("N");
}

void add_max_time(CLI::App& command, Labour& labour) {
  add_duration(command, "--max-time", labour.max_time,
               "Stop cleanly after this time, e.g. 90s, 15min, 2h; can be resumed");
}

experiment::ExperimentResult complete_result(const RunFolder& folder, const experiment::Experiment& experiment,
                                             const experiment::Store& store) {
  if (auto result = experiment::result_of(experiment, store, stop_on_signal())) return std::move(*result);
  throw experiment::sqlite::UnusableFile(
      fmt::format("{}: is damaged: stored realisations are missing; `rocking resume {}` runs them "
                  "again",
                  folder.store_path().string(), folder.name()));
}

ExitCode conclude(RunFolder& folder, const experiment::Experiment& experiment,
                  const experiment::ExperimentResult& result, const Conclusion& how) {
  const auto write = [&](const report::TextSink& sink) { report::write_report(sink, experiment, result, how.system); };
  std::exception_ptr failure;
  DrawingFailures failures;
  try {
    write_unless_stopped(folder.report_path(), write);
    failure = failure_of([&] {
      failures = write_page(folder, analysis::run_report_of(experiment, result, how.system));
      folder.install_replacement();
    });
  } catch (const base::Stopped&) {
    print_notice(fmt::format("interrupted; all realisations are done and kept. `rocking resume {}` writes the report and "
                             "its page",
                             folder.name()));
    return ExitCode::interrupted;
  }
  if (how.loudness.json) {
    print_result(write);
  } else {
    const std::string where =
        fmt::format("report: {}\npage: {}\n", folder.report_path().string(), folder.page_path().string());
    print_result(base::printable(summary_of(experiment, result) + where));
  }
  if (failure) std::rethrow_exception(failure);
  return failures.tell(no_page_picture, PictureRole::addition);
}

report::SystemFacts system_facts(unsigned threads) {
  return {.build = base::build_info(), .machine = machine_description(), .start = utc_now(), .threads = threads};
}

ExitCode carry_through(RunFolder& folder, const experiment::Experiment& experiment, experiment::Store& store,
                       const Labour& labour) {
  report::SystemFacts system = system_facts(labour.threads * labour.crew.processes);
  if (store.journalling() == experiment::Journalling::rollback) {
    print_notice(
        fmt::format("{}: this file system has no shared memory for SQLite's log; a slower journal is "
                    "used, and commands that read the run may have to wait for a moment",
                    folder.name()));
  }
  const Stretch stretch = work(folder, experiment, store, labour);
  if (stretch.end == experiment::RunEnd::stopped) {
    return explain_stop(folder, experiment::completeness(experiment, store));
  }
  if (const auto& shard = store.identity().shard) return explain_shard(folder, *shard);
  system.duration_s = stretch.duration_s;
  std::optional<experiment::ExperimentResult> result;
  try {
    result = complete_result(folder, experiment, store);
  } catch (const base::Stopped&) {
    return explain_stop(folder, experiment::completeness(experiment, store));
  }
  const ExitCode code = conclude(folder, experiment, *result, {.system = system, .loudness = labour.loudness});
  if (code == ExitCode::done && !labour.loudness.quiet) {
    print_notice(fmt::format("{} on {}", spoken_duration(system.duration_s), counted(system.threads, "thread")));
  }
  return code;
}

}  // namespace rocking::program
